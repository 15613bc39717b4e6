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

std::optional<SectorId> targetOf(const Wall& wall, std::uint32_t subWall) {
  const Portal* portal = std::get_if<Portal>(&wall);
  if (const Stack* stack = std::get_if<Stack>(&wall))
    portal = std::get_if<Portal>(&stack->subWalls[subWall].kind);
  return portal ? std::optional(portal->next) : std::nullopt;
}

}  // namespace hearth
