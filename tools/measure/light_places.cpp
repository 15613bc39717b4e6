#include "measure/light_places.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include "light/baking/mesh_light.h"
#include "light/baking/surface_places.h"
#include "light/sectors_of_meshes.h"

namespace hearth {

namespace {

/// Whether a face has a point of its plane, in texel coordinates.
bool covers(const TexelGrid& grid, const MeshFace& face, Vec2 p) {
  std::array<Vec2, 3> corners;
  std::ranges::transform(face.corners, corners.begin(),
                         [&](Vec3 corner) { return grid.toTexels(corner); });
  const auto [a, b, c] = corners;
  const std::array sides{cross(b - a, p - a), cross(c - b, p - b), cross(a - c, p - c)};
  return std::ranges::all_of(sides, [](double side) { return side >= 0; }) ||
         std::ranges::all_of(sides, [](double side) { return side <= 0; });
}

}  // namespace

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
                                               int i, int j) const {
  const Vec2 middle{i + 0.5, j + 0.5};
  const std::uint32_t firstFace = scene_.level().meshes[mesh].firstFace;
  const auto face = std::ranges::find_if(patch.faces, [&](std::uint32_t index) {
    return covers(patch.surface.grid, scene_.level().meshFaces[firstFace + index], middle);
  });
  const LitSurfaces alone{patch.surface};
  const SamplePoint at = PatchPlaces(scene_, sectors_[mesh], alone).place(middle);
  if (face == patch.faces.end() || at.isMoved) return std::nullopt;
  const std::optional<SurfacePoint> point = onFace(mesh, firstFace + *face, at.point);
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
  // One after the other: which argument of a call comes first is the compiler's choice.
  const auto anyOf = [&](const TexelRect& texels) {
    const int i = texels.i0 + static_cast<int>(below(texels.width));
    return std::pair(i, texels.j0 + static_cast<int>(below(texels.height)));
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
        const auto [i, j] = anyOf(baked_.surfaces[k]->texels);
        return onSurface(SurfaceId(k), i, j);
      });
  for (std::uint32_t mesh = 0; mesh < baked_.meshes.size(); ++mesh)
    for (const LitMesh::Patch& patch : baked_.meshes[mesh].patches)
      add(patch.surface.texels.count(), [&, mesh] {
        const auto [i, j] = anyOf(patch.surface.texels);
        return onPatch(mesh, patch, i, j);
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
