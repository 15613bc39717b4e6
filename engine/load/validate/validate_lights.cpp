#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "level/shining_textures.h"
#include "load/link/link.h"
#include "load/suggest.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether a point of a segment's plane lies on what a piece of its wall shows, sky apart.
bool liesOn(const Scene& scene, const WallPiece& piece, Vec3 p) {
  if (p.z < piece.zBottom - kInPlane || p.z > piece.zTop + kInPlane) return false;
  if (const SurfaceId* surface = std::get_if<SurfaceId>(&piece.content))
    return !isSky(scene[*surface].kind);
  const Opening& opening = std::get<Opening>(piece.content);
  const Sector& next = scene[opening.next];
  return (opening.floorSidewall && p.z <= scene.airBottom(next, p.xy()) + kInPlane) ||
         (opening.ceilingSidewall && p.z >= scene.airTop(next, p.xy()) - kInPlane) ||
         (opening.maskedMiddle &&
          p.z >= scene.geometryOf(*opening.maskedMiddle).zBottom - kInPlane &&
          p.z <= scene.geometryOf(*opening.maskedMiddle).zTop + kInPlane);
}

/// The walls of a sector that a point lies on, each authored one once.
std::vector<std::string> wallsAt(const Scene& scene, const Sector& sector, Vec3 p) {
  std::vector<std::string> walls;
  for (const Segment& segment : scene.segmentsOf(sector)) {
    if (length(nearestOnSegment(segment.p0, segment.p1, p.xy()) - p.xy()) > kInPlane) continue;
    if (std::ranges::none_of(scene.piecesOf(segment),
                             [&](const WallPiece& piece) { return liesOn(scene, piece, p); }))
      continue;
    const std::string wall =
        fmt::format("wall {} of loop \"{}\"", segment.wallIndex, sector.loops[segment.loop].name);
    if (std::ranges::find(walls, wall) == walls.end()) walls.push_back(wall);
  }
  return walls;
}

}  // namespace

void validateLight(Report& report, const Scene& scene, Place place, const LightSource& light) {
  const Sector& sector = scene[light.sector];
  const Vec3 p = light.position;
  std::vector<std::string> planes = wallsAt(scene, sector, p);
  if (sector.floorSurface && !sector.floor.isSky &&
      std::abs(p.z - scene.airBottom(sector, p.xy())) <= kInPlane)
    planes.push_back("the floor");
  if (sector.ceilingSurface && !sector.ceiling.isSky &&
      std::abs(p.z - scene.airTop(sector, p.xy())) <= kInPlane)
    planes.push_back("the ceiling");
  if (planes.empty()) return;
  report.warning(place,
                 fmt::format("the light lies in {} of sector \"{}\", and does not light it",
                             fmt::join(planes, " and in "), sector.name),
                 "move it off that plane", "light-in-plane");
}

void validateEmitter(Report& report, const Level& level, Place place, std::string_view texture) {
  const std::vector<std::string_view> shining = texturesThatCanShine(level);
  if (std::ranges::find(shining, texture) != shining.end()) return;
  const bool isWorn = std::ranges::find(level.textures, texture) != level.textures.end();
  report.warning(place, fmt::format("no surface that can shine wears \"{}\"", texture),
                 isWorn ? "name the texture of a wall, a flat or a mesh: skies, sprites and middle "
                          "textures do not shine"
                        : suggest(texture, shining, "name the texture of a wall, a flat or a mesh"),
                 "unworn-emitter");
}

}  // namespace hearth
