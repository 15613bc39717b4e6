#include "lint/texture_placement.h"

#include <fmt/format.h>

#include <cmath>

#include "lint/authored_wall.h"
#include "math/check.h"

namespace hearth {

namespace {

/// To the micrometre: what else a sum leaves is noise, and nobody would write it.
double rounded(double metres) { return std::round(metres * 1e6) / 1e6; }

/// The texture at this place.
WallTexture inLegend(const GridDescription& grid, Place place) {
  for (const LegendEntryDescription& entry : grid.legend) {
    const auto* solid = std::get_if<GridSolidDescription>(&entry.kind);
    if (!solid) continue;
    if (solid->wall.name.place == place) return {&solid->wall, "wall"};
    for (std::size_t side = 0; side < kGridSideKeys.size(); ++side)
      if (solid->sides[side] && solid->sides[side]->name.place == place)
        return {&*solid->sides[side], kGridSideKeys[side]};
  }
  CHECK(false, place.offset);
}

}  // namespace

bool isOfGrid(const LintedLevel& linted, SurfaceId surface) {
  return linted.source.level.sectors[linted.level()[surface].sector.index()].isOfGrid;
}

WallTexture textureOf(const LintedLevel& linted, SurfaceId id) {
  const Surface& surface = linted.level()[id];
  const AuthoredWall part =
      authoredWallAt(linted, *surface.segment, linted.scene().geometryOf(id).zBottom);
  if (part.solid && isOfGrid(linted, id)) return inLegend(*linted.source.level.grid, part.place);
  if (part.solid) return {&part.solid->texture, "texture"};
  const std::optional<TextureDescription>& upper = part.portal->upper;
  const std::optional<TextureDescription>& lower = part.portal->lower;
  if (upper && lower && upper->name.place == lower->name.place) return {&*upper, "texture"};
  const bool isUpper =
      surface.kind == SurfaceKind::UpperStep || surface.kind == SurfaceKind::StackUpperStep;
  return isUpper ? WallTexture{&*upper, "upper"} : WallTexture{&*lower, "lower"};
}

TexturePlacement placementOf(const LintedLevel& linted, SurfaceId surface) {
  return {linted.level()[surface].mapping.along, *linted.scene().geometryOf(surface).zRef,
          textureOf(linted, surface).description->zRef.has_value()};
}

TexturePlacement shiftedBack(const TexturePlacement& placement, Vec2 repeat, double u, double v) {
  const double along = placement.along - u * repeat.x;
  const double within = rounded(along - std::floor(along / repeat.x) * repeat.x);
  return {within < rounded(repeat.x) ? within : 0,
          v == 0 ? placement.z : rounded(placement.z - v * repeat.y), placement.hasZRef || v != 0};
}

std::string placementText(const WallTexture& texture, const TexturePlacement& placement) {
  const TextureDescription& described = *texture.description;
  std::string text = fmt::format("\"{}\": {{ \"name\": \"{}\"", texture.key, described.name.name);
  if (described.scale != Vec2{1, 1})
    text += fmt::format(", \"scale\": [{}, {}]", described.scale.x, described.scale.y);
  if (described.offset != Vec2{0, 0})
    text += fmt::format(", \"offset\": [{}, {}]", described.offset.x, described.offset.y);
  if (placement.along != 0) text += fmt::format(", \"along\": {}", placement.along);
  if (placement.hasZRef) text += fmt::format(", \"zref\": {}", placement.z);
  return text + " }";
}

}  // namespace hearth
