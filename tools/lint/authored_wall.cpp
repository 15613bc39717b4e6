#include "lint/authored_wall.h"

namespace hearth {

namespace {

/// Which part of a stack in a sector with these flats reaches above a height.
std::size_t partAbove(const Stack& stack, const SectorGeometry& flats, double z) {
  std::size_t part = 0;
  while (part + 1 < stack.subWalls.size() && stack.topOf(part, flats.zFloor, flats.zCeiling) <= z)
    ++part;
  return part;
}

}  // namespace

AuthoredWall authoredWallAt(const LintedLevel& linted, SegmentId segment, double z) {
  const WallDescription& wall = linted.source.wall(segment);
  const auto* stack = std::get_if<StackDescription>(&wall.kind);
  if (!stack)
    return {wall.place, std::get_if<SolidDescription>(&wall.kind),
            std::get_if<PortalDescription>(&wall.kind)};
  const Scene scene = linted.scene();
  const Stack& linked = std::get<Stack>(scene[segment].wall);
  const SectorGeometry& flats = scene.geometryOf(scene[scene[segment].sector]);
  const SubWallDescription& part = stack->subWalls[partAbove(linked, flats, z)];
  return {part.place, std::get_if<SolidDescription>(&part.kind),
          std::get_if<PortalDescription>(&part.kind)};
}

Place placeOf(const LintedLevel& linted, SurfaceId id) {
  const Surface& surface = linted.level()[id];
  if (surface.segment)
    return authoredWallAt(linted, *surface.segment, linted.scene().geometryOf(id).zBottom).place;
  const SectorDescription& sector = linted.source.level.sectors[surface.sector.index()];
  if (surface.kind == SurfaceKind::SlopeFloor) return sector.slopeFloor->place;
  if (surface.kind == SurfaceKind::SlopeCeiling) return sector.slopeCeil->place;
  return facesDown(surface.kind) ? sector.ceiling.place : sector.floor.place;
}

}  // namespace hearth
