#include "viewer/inspect/places.h"

#include <fmt/format.h>

#include <optional>
#include <variant>
#include <vector>

#include "load/json/report.h"
#include "viewer/inspect/words.h"

namespace hearth {

namespace {

/// As messages have it.
std::string words(const LevelSource& source, Place place) {
  Report report;
  report.error(place, "", "");
  const Diagnostic there = report.resolve(source.documents).front();
  return fmt::format("{}:{} {}", there.file, there.line, there.pointer);
}

/// What a file has of a surface.
struct Described {
  Place place;
  const TextureDescription* texture = nullptr;  ///< none where there is none of its own
};

const TextureDescription* pointerTo(const std::optional<TextureDescription>& texture) {
  return texture ? &*texture : nullptr;
}

Described describedFlat(const SectorDescription& sector, SurfaceKind kind) {
  const FlatDescription& flat = facesDown(kind) ? sector.ceiling : sector.floor;
  const auto& slope = facesDown(kind) ? sector.slopeCeil : sector.slopeFloor;
  return {slope ? slope->place : flat.place, pointerTo(flat.texture)};
}

Described describedSidewall(const SectorDescription& sector, SurfaceKind kind) {
  const SlopeDescription& slope =
      kind == SurfaceKind::FloorSidewall ? *sector.slopeFloor : *sector.slopeCeil;
  return {slope.place, pointerTo(slope.sidewall)};
}

const TextureDescription* textureOf(const PortalDescription& portal, SurfaceKind kind) {
  if (kind == SurfaceKind::MaskedMiddle) return pointerTo(portal.maskedMiddle);
  const bool isLower = kind == SurfaceKind::LowerStep || kind == SurfaceKind::StackLowerStep;
  return pointerTo(isLower ? portal.lower : portal.upper);
}

/// Of a wall or of a part of a stack.
template <typename Part>
Described describedPart(const Part& part, SurfaceKind kind) {
  if (const auto* solid = std::get_if<SolidDescription>(&part.kind))
    return {part.place, &solid->texture};
  if (const auto* portal = std::get_if<PortalDescription>(&part.kind); portal && !isSky(kind))
    return {part.place, textureOf(*portal, kind)};
  return {part.place};
}

Described described(const LevelSource& source, const Level& level, const TruthHit& surface) {
  const std::vector<SectorDescription>& sectors = source.level.sectors;
  if (!surface.segment) return describedFlat(sectors[surface.sector.index()], surface.kind);
  if (isSidewall(surface.kind))
    return describedSidewall(sectors[wedgeOf(level, surface).index()], surface.kind);
  const WallDescription& wall = source.wall(*surface.segment);
  const auto* stack = std::get_if<StackDescription>(&wall.kind);
  return stack ? describedPart(stack->subWalls[surface.subWall], surface.kind)
               : describedPart(wall, surface.kind);
}

}  // namespace

std::string placeOfSector(const LevelSource& source, SectorId sector) {
  return words(source, source.level.sectors[sector.index()].place);
}

std::string placeOfSurface(const LevelSource& source, const Level& level, const TruthHit& surface) {
  return words(source, described(source, level, surface).place);
}

std::string placeOfTexture(const LevelSource& source, const Level& level, const TruthHit& surface) {
  const Described found = described(source, level, surface);
  return words(source, found.texture ? found.texture->name.place : found.place);
}

std::string placeOfLight(const LevelSource& source, std::size_t light) {
  return words(source, source.lights.lights[light].place);
}

}  // namespace hearth
