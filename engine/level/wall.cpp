#include "level/wall.h"

#include <algorithm>

namespace hearth {

std::vector<SectorId> targetsOf(const Wall& wall) {
  std::vector<SectorId> targets;
  if (const Portal* portal = std::get_if<Portal>(&wall)) targets.push_back(portal->next);
  if (const Stack* stack = std::get_if<Stack>(&wall))
    for (const SubWall& subWall : stack->subWalls)
      if (const Portal* portal = std::get_if<Portal>(&subWall.kind))
        targets.push_back(portal->next);
  std::sort(targets.begin(), targets.end());
  targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  return targets;
}

}  // namespace hearth
