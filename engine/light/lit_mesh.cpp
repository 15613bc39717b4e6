#include "light/lit_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "light/grid/mesh_patches.h"
#include "math/parallel.h"

namespace hearth {

namespace {

struct AtlasPlace {
  int i;
  int j;
};

/// Places rectangles in an atlas, one beside the other on shelves as high as the first of each.
class AtlasShelves {
 public:
  explicit AtlasShelves(std::int64_t width) : width_(width) {}

  AtlasPlace add(std::int64_t width, std::int64_t height) {
    if (used_ + width > width_) nextShelf();
    height_ = std::max(height_, height);
    const AtlasPlace place{within(used_), within(top_)};
    used_ += width;
    widest_ = std::max(widest_, used_);
    return place;
  }
  void nextShelf() {
    top_ += height_;
    used_ = height_ = 0;
  }
  TexelRect texels() const { return {0, 0, within(widest_), within(top_ + height_)}; }

 private:
  /// What is larger is refused by mistakeInTexel.
  static int within(std::int64_t texels) {
    return static_cast<int>(std::min<std::int64_t>(texels, std::numeric_limits<int>::max()));
  }

  std::int64_t width_;
  std::int64_t used_ = 0;
  std::int64_t widest_ = 0;
  std::int64_t top_ = 0;
  std::int64_t height_ = 0;
};

/// About as wide as high.
std::int64_t atlasWidth(const DividedMesh& divided) {
  std::int64_t widest = kSmallFaceSide;
  std::int64_t texels = std::ssize(divided.smallFaces) * kSmallFaceSide * kSmallFaceSide;
  for (const MeshPatch& patch : divided.patches) {
    widest = std::max<std::int64_t>(widest, patch.surface.texels.width);
    texels += patch.surface.texels.count();
  }
  return std::max(widest,
                  static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(texels)))));
}

/// By falling height.
std::vector<std::size_t> highestFirst(const std::vector<MeshPatch>& patches) {
  std::vector<std::size_t> order(patches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::size_t patch) { return patches[patch].surface.texels.height; });
  return order;
}

}  // namespace

LitMesh makeLitMesh(const Level& level, std::uint32_t index, double texel) {
  const std::span<const MeshFace> faces = level.facesOf(level.meshes[index]);
  DividedMesh divided = dividedMesh(faces, texel);
  AtlasShelves shelves(atlasWidth(divided));
  LitMesh mesh;
  mesh.surface = level.meshes[index].surface;
  mesh.places.resize(faces.size());
  for (const std::size_t highest : highestFirst(divided.patches)) {
    MeshPatch& patch = divided.patches[highest];
    const TexelRect& texels = patch.surface.texels;
    const auto [i, j] = shelves.add(texels.width, texels.height);
    const Vec2 shift{1.0 * i - texels.i0, 1.0 * j - texels.j0};
    for (const std::uint32_t face : patch.faces)
      for (std::size_t k = 0; k < 3; ++k)
        mesh.places[face][k] = patch.surface.grid.toTexels(faces[face].corners[k]) + shift;
    mesh.patches.push_back({std::move(patch.faces), std::move(patch.surface), i, j});
  }
  shelves.nextShelf();
  for (const std::uint32_t face : divided.smallFaces) {
    const auto [i, j] = shelves.add(kSmallFaceSide, kSmallFaceSide);
    const Vec2 middle{i + 0.5, j + 0.5};
    mesh.places[face] = {middle, middle + Vec2{1, 0}, middle + Vec2{0, 1}};
    mesh.smallFaces.push_back({face, i, j});
  }
  mesh.texels = shelves.texels();
  return mesh;
}

Vec2 placeOn(const LitMesh& mesh, std::uint32_t index, const MeshFace& face, Vec3 point) {
  const auto& [a, b, c] = face.corners;
  const Vec3 out = frontOf(face);
  const auto weight = [&](Vec3 from, Vec3 to) {
    return dot(out, cross(to - point, from - point)) / dot(out, out);
  };
  const auto& [atA, atB, atC] = mesh.places[index];
  return weight(b, c) * atA + weight(c, a) * atB + weight(a, b) * atC;
}

std::vector<LitMesh> makeLitMeshes(const Level& level, double texel, int threads) {
  std::vector<std::uint32_t> all(level.meshes.size());
  std::iota(all.begin(), all.end(), 0U);
  return makeLitMeshes(level, texel, all, threads);
}

std::vector<LitMesh> makeLitMeshes(const Level& level, double texel,
                                   std::span<const std::uint32_t> meshes, int threads) {
  std::vector<LitMesh> lit(level.meshes.size());
  parallelFor(meshes.size(), threads,
              [&](std::size_t i) { lit[meshes[i]] = makeLitMesh(level, meshes[i], texel); });
  return lit;
}

void keepOnly(std::span<const std::uint32_t> faces, const Mesh& of, LitMesh& mesh) {
  const auto isKept = [&](std::uint32_t face) {
    return std::ranges::binary_search(faces, of.firstFace + face);
  };
  std::erase_if(mesh.patches, [&](const LitMesh::Patch& patch) {
    return std::ranges::none_of(patch.faces, isKept);
  });
  std::erase_if(mesh.smallFaces,
                [&](const LitMesh::SmallFace& small) { return !isKept(small.face); });
}

std::int64_t texelsOfSmallFaces(std::span<const LitMesh::SmallFace> faces) {
  return std::ssize(faces) * kSmallFaceSide * kSmallFaceSide;
}

std::vector<std::span<const LitMesh::SmallFace>> smallFacesAtOnce(const LitMesh& mesh) {
  constexpr std::size_t kAtOnce = 512;
  std::vector<std::span<const LitMesh::SmallFace>> parts;
  std::span<const LitMesh::SmallFace> left = mesh.smallFaces;
  while (!left.empty()) {
    parts.push_back(left.first(std::min(kAtOnce, left.size())));
    left = left.subspan(parts.back().size());
  }
  return parts;
}

}  // namespace hearth
