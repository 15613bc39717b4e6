#include "viewer/inspect/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include "level/thing_name.h"
#include "render/glow.h"
#include "viewer/inspect/remedy.h"

namespace hearth {

namespace {

/// Levels from which on light is more than next to nothing.
constexpr double kFaintLevel = 16;

/// To so many decimals and without zeros at the end.
std::string rounded(double value, int decimals) {
  const double unit = std::pow(10, decimals);
  return fmt::format("{:g}", std::round(value * unit) / unit + 0.0);  // no -0
}

std::string metres(double value) { return fmt::format("{}", std::round(value * 1e3) / 1e3 + 0.0); }

std::string wallWords(const Level& level, const TruthHit& place) {
  const Segment& segment = level[*place.segment];
  const Sector& sector = level[segment.sector];
  const bool isStack = std::holds_alternative<Stack>(segment.wall);
  const std::string part = isStack ? fmt::format(" part {}", place.subWall) : "";
  const std::string loop = segment.loop > 0 ? "/" + sector.loops[segment.loop].name : "";
  return fmt::format("wall {}{} of {}{}", segment.wallIndex, part, sector.name, loop);
}

std::string sidewallWords(const Level& level, const TruthHit& place) {
  const std::string_view flat = facesDown(place.kind) ? "ceiling" : "floor";
  return fmt::format("sidewall of the sloped {} of {}, at {}", flat,
                     level[slopedSectorOf(level, place)].name, wallWords(level, place));
}

std::string remedyWords(const LightSource& light, const LightFinding& finding) {
  const std::optional<Remedy> remedy = remedyFor(light, finding);
  if (!remedy) return "its color is black";
  if (remedy->falloff)
    return fmt::format("falloff {:g} instead of {:g} would give {}", *remedy->falloff,
                       light.falloff, kClearLevel);
  if (remedy->intensity)
    return fmt::format("intensity {:g} instead of {:g} would give {}", *remedy->intensity,
                       light.intensity, kClearLevel);
  return fmt::format("raise its curve to {:g} at {} m", *remedy->curveLevel,
                     rounded(finding.distance, 1));
}

std::string weakWords(const LightSource& light, const LightFinding& finding) {
  const std::string_view cosine = finding.unshaded < finding.level ? ", grazing the surface" : "";
  const std::string at =
      light.hasPlace() ? fmt::format(" at {} m", rounded(finding.distance, 2)) : "";
  return fmt::format("too weak here: {} of 255{}{}; {}", rounded(finding.level, 2), at, cosine,
                     remedyWords(light, finding));
}

/// The way to the front of a surface, along the axis that is nearest to it.
std::string_view sideWords(Vec3 normal) {
  const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  if (size.z > std::max(size.x, size.y)) return normal.z > 0 ? "up" : "down";
  if (size.x > size.y) return normal.x > 0 ? "to larger x" : "to smaller x";
  return normal.y > 0 ? "to larger y" : "to smaller y";
}

std::string facesAwayWords(const LightSource& light, const SurfacePoint& place) {
  if (light.sun) return "faces away: this surface looks to the other side of the sky";
  const double behind = dot(place.normal, place.point - light.position);
  return fmt::format("faces away: it is {} m behind this surface; move it to this side, {}",
                     rounded(behind, 2), sideWords(place.normal));
}

std::string blockedWords(const Level& level, const LightFinding& finding) {
  if (level.lights[finding.light].sun)
    return fmt::format("blocked by {} ({}): open a way to the sky there, or turn the sun",
                       surfaceWords(level, *finding.blocker),
                       pointWords(finding.blocker->point, ", "));
  const std::string advice =
      finding.lift ? fmt::format("{} it {} m or more", *finding.lift > 0 ? "raise" : "lower",
                                 rounded(std::abs(*finding.lift), 1))
                   : "move it to where nothing is between";
  return fmt::format("blocked by {} ({}): {}", surfaceWords(level, *finding.blocker),
                     pointWords(finding.blocker->point, ", "), advice);
}

std::string areaWords(const Level& level, const LightFinding& finding) {
  const double percent = 100 * finding.seenFraction;
  if (level.lights[finding.light].isSky)
    return fmt::format("{:.0f} % of what level ground in the open gets", percent);
  return fmt::format("{:.0f} % of what a place gets that sees nothing else", percent);
}

std::string_view brightnessWord(double level) {
  if (level < kClearLevel) return "dark";
  return level < 2 * kClearLevel ? "dim" : "lit";
}

std::string lightsWords(const Level& level, double sum) {
  if (level.lights.empty()) return "the level has no lights";
  if (sum == 0) return "no light gives it anything";
  return fmt::format("lights give {}{}", levelWords(sum),
                     sum < kFaintLevel ? ", next to nothing" : "");
}

/// Of what the lights, its sector's own light and its own texture give.
std::string brightnessOf(const Level& level, SectorId sector, double lights, double shines = 0) {
  const double own = 255 * level[sector].light;
  const double sum = lights + own + shines;
  std::string words = fmt::format("{}, {} of 255: {}", brightnessWord(sum), levelWords(sum),
                                  lightsWords(level, lights));
  if (own > 0) words += fmt::format("; the sector's own light gives {}", levelWords(own));
  if (shines > 0) words += fmt::format("; its texture shines with {}", levelWords(shines));
  return words;
}

/// Levels that are added to what is drawn of a surface, or a face, with that texture.
double shiningOf(const Level& level, SurfaceKind kind, TextureId texture) {
  return 255 * brightest(Glow(level).of(kind, texture));
}

}  // namespace

std::string surfaceWords(const Level& level, const TruthHit& place) {
  if (place.mesh) return meshWords(level, indexOfMesh(level, place));
  if (!place.segment) return fmt::format("{} of {}", name(place.kind), level[place.sector].name);
  if (isSidewall(place.kind)) return sidewallWords(level, place);
  if (place.kind == SurfaceKind::Solid || place.kind == SurfaceKind::StackSolid)
    return wallWords(level, place);
  return fmt::format("{} at {}", name(place.kind), wallWords(level, place));
}

std::size_t indexOfMesh(const Level& level, const TruthHit& onMesh) {
  return static_cast<std::size_t>(&level.meshOf(*onMesh.mesh) - level.meshes.data());
}

SectorId slopedSectorOf(const Level& level, const TruthHit& sidewall) {
  const Segment& segment = level[*sidewall.segment];
  const auto nextOf = [](const auto& kind) { return std::get<Portal>(kind).next; };
  if (const Stack* stack = std::get_if<Stack>(&segment.wall))
    return nextOf(stack->subWalls[sidewall.subWall].kind);
  return nextOf(segment.wall);
}

std::string pointWords(Vec3 point, std::string_view separator) {
  return fmt::format("{}{}{}{}{}", metres(point.x), separator, metres(point.y), separator,
                     metres(point.z));
}

std::string levelWords(double level) { return rounded(level, level < 10 ? 1 : 0); }

double brightest(Vec3 levels) { return std::max({levels.x, levels.y, levels.z}); }

std::string brightnessWords(const Level& level, const Inspection& found) {
  if (!found.lightmap) return "sky: always fully bright";
  return brightnessOf(level, found.place.sector, brightest(found.sum + found.bounced),
                      shiningOf(level, found.place.kind, found.place.texture->texture));
}

std::string spriteWords(const Level& level, std::size_t sprite) {
  const Sprite& found = level.sprites[sprite];
  return fmt::format("{} \"{}\"", name(level[found.surface].kind), nameOf(level, found));
}

std::string spriteBrightnessWords(const Level& level, std::size_t sprite, const BakedLight& light) {
  const Sprite& found = level.sprites[sprite];
  if (found.isBright) return "bright: shows as it is";
  Vec3 levels;
  if (const auto& map = light.lightmaps[found.surface.index()])
    levels = {double(map->at(0, 0, 0)), double(map->at(0, 0, 1)), double(map->at(0, 0, 2))};
  return brightnessOf(level, found.sector, brightest(levels));
}

std::string meshWords(const Level& level, std::size_t mesh) {
  const Mesh& found = level.meshes[mesh];
  const std::string_view quote = found.name.empty() ? "" : "\"";
  return fmt::format("{} {}{}{}", name(level[found.surface].kind), quote, nameOf(level, found),
                     quote);
}

std::string meshBrightnessWords(const Level& level, const MeshHit& found, const BakedLight& light) {
  const Mesh& mesh = level.meshes[found.mesh];
  Vec3 levels;
  if (const auto& map = light.lightmaps[mesh.surface.index()]) {
    const Vec2 at = placeOn(light.meshes[found.mesh], found.face - mesh.firstFace,
                            level.meshFaces[found.face], found.point);
    levels = {map->sample(at.x, at.y, 0), map->sample(at.x, at.y, 1), map->sample(at.x, at.y, 2)};
  }
  return brightnessOf(level, mesh.sector, brightest(levels),
                      shiningOf(level, SurfaceKind::Mesh, level.meshFaces[found.face].texture));
}

std::string reasonWords(const Level& level, const SurfacePoint& place,
                        const LightFinding& finding) {
  switch (finding.reason) {
    case LightReason::Lights:
      if (level.lights[finding.light].isArea()) return areaWords(level, finding);
      if (finding.seenFraction < 1)
        return fmt::format("{:.0f} % of it seen", 100 * finding.seenFraction);
      return brightest(finding.adds) < kFaintLevel ? weakWords(level.lights[finding.light], finding)
                                                   : "";
    case LightReason::TooWeak:
      return weakWords(level.lights[finding.light], finding);
    case LightReason::OutsideSpot:
      return fmt::format(
          "outside its spot, which ends {:g} degrees from its direction: turn it, or "
          "give it a larger \"outer\"",
          level.lights[finding.light].spot->outer());
    case LightReason::FacesAway:
      return facesAwayWords(level.lights[finding.light], place);
    case LightReason::InPlane:
      if (level.lights[finding.light].sun)
        return "in the plane of this surface, which it only grazes: turn the sun";
      return fmt::format("in the plane of this surface: move it off the plane, {}",
                         sideWords(place.normal));
    case LightReason::Blocked:
      return blockedWords(level, finding);
    case LightReason::NotReached:
      return "not reached: it shines in a part of the level from which no straight way leads here";
    case LightReason::NoneSeen:
      if (level.lights[finding.light].isSky)
        return "not seen: no straight way leads from here to the sky";
      return fmt::format("not seen: no straight way leads from here to \"{}\"",
                         level.lights[finding.light].texture);
  }
  return "";
}

}  // namespace hearth
