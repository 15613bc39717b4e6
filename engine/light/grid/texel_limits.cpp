#include "light/grid/texel_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "level/thing_name.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"
#include "light/ray_error.h"

namespace hearth {

namespace {

/// Texels of one bake. More than that is a slip of the pen in `texel`: 4 GiB of light.
constexpr double kMaxTexels = 4294967296.0;

/// Texels from the origin of their grid; beyond, whole numbers of 32 bits would not count them.
constexpr double kFarthestTexel = 1 << 30;

/// Metres. No coordinate of the level is greater.
double reachOf(const Scene& scene) {
  double reach = 0;
  for (const Sector& sector : scene.level().sectors)
    for (const double coordinate : {sector.box.min.x, sector.box.min.y, sector.box.max.x,
                                    sector.box.max.y, scene.zFloor(sector), scene.zCeiling(sector)})
      reach = std::max(reach, std::abs(coordinate));
  for (const FaceTree& mesh : scene.level().faceTrees)
    for (const Vec3 corner : {mesh.box().min, mesh.box().max})
      reach = std::max(reach, largestCoordinate(corner));
  return reach;
}

/// At least as many texels as a bake computes: every wall, flat and face of a mesh as a rectangle.
double texelBound(const Scene& scene, double texel) {
  const auto cells = [texel](double metres) { return metres / texel + 3; };
  double sum = 0;
  for (const Sector& sector : scene.level().sectors) {
    const Vec2 size = sector.box.max - sector.box.min;
    sum += 2 * cells(size.x) * cells(size.y);
    for (const Segment& segment : scene.segmentsOf(sector))
      sum += cells(segment.length) * cells(scene.zCeiling(sector) - scene.zFloor(sector));
  }
  for (const MeshFace& face : scene.level().meshFaces) {
    const double longest = std::max(length(face.corners[1] - face.corners[0]),
                                    length(face.corners[2] - face.corners[0]));
    sum += cells(2 * longest) * cells(2 * longest);
  }
  return sum;
}

/// As many as a bake computes.
struct TexelCount {
  double sum = 0;
  double ofLargestMesh = 0;
  std::size_t largestMesh = 0;  ///< index
};

/// Takes long, and a reach within limits.
TexelCount countTexels(const Scene& scene, double texel) {
  TexelCount count;
  for (const auto& surface : makeLitSurfaces(scene, texel))
    if (surface) count.sum += static_cast<double>(surface->texels.count());
  const std::vector<LitMesh> meshes = makeLitMeshes(scene.level(), texel, 1);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto texels = static_cast<double>(meshes[i].texels.count());
    count.sum += texels;
    if (texels <= count.ofLargestMesh) continue;
    count.ofLargestMesh = texels;
    count.largestMesh = i;
  }
  return count;
}

std::string mistakeInCount(const Level& level, double texel, const TexelCount& count) {
  const std::string message =
      fmt::format("{} m would take {:.3g} texels, more than {:.3g}", texel, count.sum, kMaxTexels);
  if (count.ofLargestMesh < count.sum / 2) return fmt::format("{}: use larger ones", message);
  return fmt::format("{}, most of them on mesh {}: correct its scale, or use larger ones", message,
                     nameOf(level, level.meshes[count.largestMesh]));
}

}  // namespace

std::optional<std::string> mistakeInTexel(const Scene& scene, double texel) {
  if (!std::isfinite(texel) || texel <= 0) return fmt::format("{} m is no size", texel);
  if (const double reach = reachOf(scene); reach / texel > kFarthestTexel)
    return fmt::format(
        "a level that reaches {:.3g} m from the origin needs texels of {:.3g} m at least", reach,
        reach / kFarthestTexel);
  if (texelBound(scene, texel) <= kMaxTexels) return std::nullopt;
  const TexelCount count = countTexels(scene, texel);
  return count.sum > kMaxTexels ? std::optional(mistakeInCount(scene.level(), texel, count))
                                : std::nullopt;
}

}  // namespace hearth
