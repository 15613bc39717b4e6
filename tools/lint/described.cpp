#include "lint/described.h"

#include <algorithm>

namespace hearth {

namespace {

/// Which part of a stack reaches above a height.
std::size_t partAbove(const Stack& stack, double z) {
  const auto part = std::ranges::upper_bound(stack.subWalls, z, {}, &SubWall::zTop);
  return std::min(static_cast<std::size_t>(part - stack.subWalls.begin()),
                  stack.subWalls.size() - 1);
}

}  // namespace

DescribedPart describedPart(const LintedLevel& linted, SegmentId segment, double z) {
  const WallDescription& wall = linted.source.wall(segment);
  const auto* stack = std::get_if<StackDescription>(&wall.kind);
  if (!stack)
    return {wall.place, std::get_if<SolidDescription>(&wall.kind),
            std::get_if<PortalDescription>(&wall.kind)};
  const Stack& linked = std::get<Stack>(linted.level()[segment].kind);
  const SubWallDescription& part = stack->subWalls[partAbove(linked, z)];
  return {part.place, std::get_if<SolidDescription>(&part.kind),
          std::get_if<PortalDescription>(&part.kind)};
}

Place placeOf(const LintedLevel& linted, const Surface& surface) {
  if (surface.segment) return describedPart(linted, *surface.segment, surface.zBottom).place;
  const SectorDescription& sector = linted.source.level.sectors[surface.sector.index()];
  if (surface.kind == SurfaceKind::SlopeFloor) return sector.slopeFloor->place;
  if (surface.kind == SurfaceKind::SlopeCeiling) return sector.slopeCeil->place;
  return isOverhead(surface.kind) ? sector.ceiling.place : sector.floor.place;
}

}  // namespace hearth
