#include "measure/light_places.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "light/baking/mesh_light.h"
#include "light/baking/surface_places.h"
#include "light/sectors_of_meshes.h"

namespace hearth {

LightPlaces::LightPlaces(const Scene& scene, const BakedLight& baked)
    : scene_(scene), baked_(baked), sectors_(sectorsOfMeshes(scene.level())) {}

std::optional<LightPlace> LightPlaces::onSurface(SurfaceId id, int i, int j) const {
  const SurfacePlaces places(scene_, baked_.surfaces, id);
  const Vec2 middle{i + 0.5, j + 0.5};
  const SamplePoint at = places.place(middle);
  if (at.isMoved || places.isLeftOut(at) || !baked_.surfaces[id.index()]->outline.contains(middle))
    return std::nullopt;
  const Surface& there = scene_[at.surface];
  return LightPlace{id,
                    i,
                    j,
                    {there.kind, there.sector, there.segment, at.target,
                     baked_.surfaces[at.surface.index()]->normal}};
}

std::optional<LightPlace> LightPlaces::onPatch(std::uint32_t mesh, const LitMesh::Patch& patch,
                                               std::uint32_t face) const {
  const auto& [a, b, c] = scene_.level().meshFaces[face].corners;
  const Vec2 texel = patch.surface.grid.toTexels((1 / 3.0) * (a + b + c));
  const int i = static_cast<int>(std::floor(texel.x));
  const int j = static_cast<int>(std::floor(texel.y));
  const LitSurfaces alone{patch.surface};
  const SamplePoint at = PatchPlaces(scene_, sectors_[mesh], alone).place({i + 0.5, j + 0.5});
  if (at.isMoved) return std::nullopt;
  const std::optional<SurfacePoint> point = onFace(mesh, face, at.point);
  if (!point) return std::nullopt;
  const TexelRect& texels = patch.surface.texels;
  return LightPlace{*point->mesh, patch.i + i - texels.i0, patch.j + j - texels.j0, *point};
}

std::optional<SurfacePoint> LightPlaces::onFace(std::uint32_t index, std::uint32_t face,
                                                Vec3 point) const {
  if (!isInAir(scene_, sectors_[index], point)) return std::nullopt;
  const Mesh& mesh = scene_.level().meshes[index];
  const Vec3 front = frontOf(scene_.level().meshFaces[face]);
  SurfacePoint place{SurfaceKind::Mesh, mesh.sector, std::nullopt, point,
                     (1 / length(front)) * front};
  place.mesh = mesh.surface;
  place.face = face;
  return place;
}

std::vector<LightPlace> LightPlaces::some(
    std::size_t count, const std::function<bool(const LightPlace&)>& isWanted) const {
  std::mt19937_64 random;  // the same numbers everywhere; not so the distributions of <random>
  const auto below = [&](std::int64_t end) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(end));
  };
  using Draw = std::function<std::optional<LightPlace>()>;
  std::vector<std::int64_t> ends;  // of surfaces and patches, counted in texels
  std::vector<Draw> draws;
  const auto add = [&](std::int64_t texels, Draw draw) {
    ends.push_back((ends.empty() ? 0 : ends.back()) + texels);
    draws.push_back(std::move(draw));
  };
  for (std::size_t k = 0; k < baked_.surfaces.size(); ++k)
    if (const std::optional<LitSurface>& lit = baked_.surfaces[k])
      add(lit->texels.count(), [&, k] {
        const TexelRect& texels = baked_.surfaces[k]->texels;
        return onSurface(SurfaceId(k), texels.i0 + static_cast<int>(below(texels.width)),
                         texels.j0 + static_cast<int>(below(texels.height)));
      });
  for (std::uint32_t mesh = 0; mesh < baked_.meshes.size(); ++mesh)
    for (const LitMesh::Patch& patch : baked_.meshes[mesh].patches)
      add(patch.surface.texels.count(), [&, mesh] {
        const auto its = static_cast<std::size_t>(below(std::ssize(patch.faces)));
        return onPatch(mesh, patch, scene_.level().meshes[mesh].firstFace + patch.faces[its]);
      });
  std::vector<LightPlace> places;
  if (ends.empty()) return places;
  constexpr std::size_t kDrawsOfPlace = 100;
  for (std::size_t k = 0; k < kDrawsOfPlace * count && places.size() < count; ++k) {
    const auto drawn = std::ranges::upper_bound(ends, below(ends.back())) - ends.begin();
    const std::optional<LightPlace> place = draws[static_cast<std::size_t>(drawn)]();
    if (place && isWanted(*place)) places.push_back(*place);
  }
  return places;
}

}  // namespace hearth
