#include "lint/hanging.h"

#include <fmt/format.h>

#include <cmath>

#include "lint/authored_wall.h"

namespace hearth {

namespace {

/// To the micrometre: what else a sum leaves is noise, and nobody would write it.
double rounded(double metres) { return std::round(metres * 1e6) / 1e6; }

}  // namespace

WallTexture textureOf(const LintedLevel& linted, SurfaceId id) {
  const Surface& surface = linted.level()[id];
  const AuthoredWall part =
      authoredWallAt(linted, *surface.segment, linted.scene().geometryOf(id).zBottom);
  if (part.solid) return {&part.solid->texture, "texture"};
  const std::optional<TextureDescription>& upper = part.portal->upper;
  const std::optional<TextureDescription>& lower = part.portal->lower;
  if (upper && lower && upper->name.place == lower->name.place) return {&*upper, "texture"};
  const bool isUpper =
      surface.kind == SurfaceKind::UpperStep || surface.kind == SurfaceKind::StackUpperStep;
  return isUpper ? WallTexture{&*upper, "upper"} : WallTexture{&*lower, "lower"};
}

Hanging hangingOf(const LintedLevel& linted, SurfaceId surface) {
  return {linted.level()[surface].mapping.along, *linted.scene().geometryOf(surface).zRef,
          textureOf(linted, surface).described->zRef.has_value()};
}

Hanging movedBack(const Hanging& hanging, Vec2 repeat, double u, double v) {
  const double along = hanging.along - u * repeat.x;
  const double within = rounded(along - std::floor(along / repeat.x) * repeat.x);
  return {within < rounded(repeat.x) ? within : 0,
          v == 0 ? hanging.z : rounded(hanging.z - v * repeat.y), hanging.hasZRef || v != 0};
}

std::string written(const WallTexture& texture, const Hanging& hanging) {
  const TextureDescription& described = *texture.described;
  std::string text = fmt::format("\"{}\": {{ \"name\": \"{}\"", texture.key, described.name.name);
  if (described.scale != Vec2{1, 1})
    text += fmt::format(", \"scale\": [{}, {}]", described.scale.x, described.scale.y);
  if (described.offset != Vec2{0, 0})
    text += fmt::format(", \"offset\": [{}, {}]", described.offset.x, described.offset.y);
  if (hanging.along != 0) text += fmt::format(", \"along\": {}", hanging.along);
  if (hanging.hasZRef) text += fmt::format(", \"zref\": {}", hanging.z);
  return text + " }";
}

}  // namespace hearth
