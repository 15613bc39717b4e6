#include "viewer/inspect/places.h"

#include <fmt/format.h>

#include <optional>
#include <variant>
#include <vector>

#include "load/json/report.h"
#include "viewer/inspect/words.h"

namespace hearth {

namespace {

/// FILE:LINE POINTER, as in diagnostics.
std::string formatPlace(const LevelSource& source, Place place) {
  const FileLocation location = locationOf(place, source.documents);
  return fmt::format("{}:{} {}", location.file, location.line, location.pointer);
}

/// Where a file describes a surface.
struct AuthoredSurface {
  Place place;
  const TextureDescription* texture = nullptr;  ///< none where there is none of its own
};

const TextureDescription* pointerTo(const std::optional<TextureDescription>& texture) {
  return texture ? &*texture : nullptr;
}

AuthoredSurface authoredFlat(const SectorDescription& sector, SurfaceKind kind) {
  const FlatDescription& flat = facesDown(kind) ? sector.ceiling : sector.floor;
  const auto& slope = facesDown(kind) ? sector.slopeCeil : sector.slopeFloor;
  return {slope ? slope->place : flat.place, pointerTo(flat.texture)};
}

AuthoredSurface authoredSidewall(const SectorDescription& sector, SurfaceKind kind) {
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
AuthoredSurface authoredPart(const Part& part, SurfaceKind kind) {
  if (const auto* solid = std::get_if<SolidDescription>(&part.kind))
    return {part.place, &solid->texture};
  if (const auto* portal = std::get_if<PortalDescription>(&part.kind); portal && !isSky(kind))
    return {part.place, textureOf(*portal, kind)};
  return {part.place};
}

AuthoredSurface authored(const LevelSource& source, const Level& level, const TruthHit& surface) {
  const std::vector<SectorDescription>& sectors = source.level.sectors;
  if (!surface.segment) return authoredFlat(sectors[surface.sector.index()], surface.kind);
  if (isSidewall(surface.kind))
    return authoredSidewall(sectors[slopedSectorOf(level, surface).index()], surface.kind);
  const WallDescription& wall = source.wall(*surface.segment);
  const auto* stack = std::get_if<StackDescription>(&wall.kind);
  return stack ? authoredPart(stack->subWalls[surface.subWall], surface.kind)
               : authoredPart(wall, surface.kind);
}

}  // namespace

std::string placeOfSector(const LevelSource& source, SectorId sector) {
  return formatPlace(source, source.level.sectors[sector.index()].place);
}

std::string placeOfSurface(const LevelSource& source, const Level& level, const TruthHit& surface) {
  if (surface.mesh) return placeOfMesh(source, indexOfMesh(level, surface));
  return formatPlace(source, authored(source, level, surface).place);
}

std::string placeOfTexture(const LevelSource& source, const Level& level, const TruthHit& surface) {
  const AuthoredSurface found = authored(source, level, surface);
  return formatPlace(source, found.texture ? found.texture->name.place : found.place);
}

std::string placeOfSprite(const LevelSource& source, std::size_t sprite) {
  return formatPlace(source, source.level.sprites[sprite].place);
}

std::string placeOfSpriteImage(const LevelSource& source, std::size_t sprite) {
  return formatPlace(source, source.level.sprites[sprite].frames.front().front().place);
}

std::string placeOfMesh(const LevelSource& source, std::size_t mesh) {
  return formatPlace(source, source.level.meshes[mesh].place);
}

std::string placeOfModel(const LevelSource& source, std::size_t mesh) {
  return formatPlace(source, source.level.meshes[mesh].file.place);
}

std::string placeOfLight(const LevelSource& source, std::size_t light) {
  return formatPlace(source, source.lights.at(light).place);
}

}  // namespace hearth
