#include "support/baked_room.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "math/check.h"
#include "support/level_text.h"

namespace hearth::test {

namespace {

/// Of the corners of a face at a point of it; none of a point that is not on it.
std::optional<Vec3> weightsAt(const MeshFace& face, Vec3 p, Vec3 front) {
  constexpr double kNear = 1e-6;
  const auto& [a, b, c] = face.corners;
  const Vec3 out = frontOf(face);
  const double area = dot(out, out);
  if (dot(out, front) <= 0 || std::abs(dot(out, p - a)) > kNear * std::sqrt(area))
    return std::nullopt;
  const auto weight = [&](Vec3 from, Vec3 to) { return dot(out, cross(to - p, from - p)) / area; };
  const Vec3 weights{weight(b, c), weight(c, a), weight(a, b)};
  const bool isOnFace = weights.x > -kNear && weights.y > -kNear && weights.z > -kNear;
  return isOnFace ? std::optional(weights) : std::nullopt;
}

}  // namespace

BakedRoom::BakedRoom(std::string_view levelText, std::string_view lightsText, int threads)
    : BakedRoom(levelFrom(levelText, lightsText), threads) {}

BakedRoom::BakedRoom(LoadedLevel loaded, int threads)
    : loaded_(std::move(loaded)), light_(bake(loaded_.scene(), loaded_.level.bake, threads)) {}

double BakedRoom::at(SurfaceKind kind, Vec3 p, std::string_view sector, int channel) const {
  const std::optional<SurfaceId> id = surfaceAt(kind, p, sector);
  CHECK(id, name(kind), p.x, p.y, p.z);
  const auto& lightmap = light_.lightmaps[id->index()];
  const Vec2 texels = light_.surfaces[id->index()]->grid.toTexels(p);
  return lightmap ? lightmap->sample(texels.x, texels.y, channel) : 0;
}

double BakedRoom::onMesh(Vec3 p, Vec3 front, int channel) const {
  for (std::size_t i = 0; i < level().meshes.size(); ++i) {
    const std::span<const MeshFace> faces = level().facesOf(level().meshes[i]);
    for (std::size_t k = 0; k < faces.size(); ++k) {
      const std::optional<Vec3> weights = weightsAt(faces[k], p, front);
      if (!weights) continue;
      const LitMesh& lit = light_.meshes[i];
      const auto& [a, b, c] = lit.places[k];
      const Vec2 at = weights->x * a + weights->y * b + weights->z * c;
      const auto& lightmap = light_.lightmaps[lit.surface.index()];
      return lightmap ? lightmap->sample(at.x, at.y, channel) : 0;
    }
  }
  CHECK(false, "no face", p.x, p.y, p.z);
  return 0;
}

std::optional<SurfaceId> BakedRoom::surfaceAt(SurfaceKind kind, Vec3 p,
                                              std::string_view sector) const {
  constexpr double kNear = 1e-6;
  for (const SurfaceId id : scene().shownSurfaces()) {
    const Surface& surface = level()[id];
    const auto& lit = light_.surfaces[id.index()];
    if (surface.kind != kind || !lit || std::abs(lit->distanceInFront(p)) > kNear) continue;
    if (!sector.empty() && level()[surface.sector].name != sector) continue;
    const Vec2 texels = lit->grid.toTexels(p);
    if (lit->outline.contains(texels) || length(lit->outline.nearest(texels) - texels) < kNear)
      return id;
  }
  return std::nullopt;
}

BakedLight withAllTexels(BakedLight light) {
  for (auto& map : light.lightmaps) {
    if (!map || !map->isUniform()) continue;
    const std::vector<std::uint8_t> one = std::exchange(map->levels, {});
    for (std::int64_t i = 0; i < map->rect.count(); ++i)
      map->levels.insert(map->levels.end(), one.begin(), one.end());
  }
  return light;
}

}  // namespace hearth::test
