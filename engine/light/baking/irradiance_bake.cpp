#include "light/baking/irradiance_bake.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "light/baking/baked_surface.h"
#include "light/baking/corner_light.h"
#include "light/baking/light_sum.h"
#include "light/baking/light_visibility.h"
#include "light/baking/mesh_light.h"
#include "light/baking/patch_light.h"
#include "light/baking/surface_light.h"
#include "light/grid/texel_limits.h"
#include "light/sectors_of_meshes.h"
#include "math/parallel.h"

namespace hearth {

namespace {

/// Small enough for light that is reflected nearby: metres, ...
constexpr double kTexel = 0.0625;
/// ... or a part of a bake's texel.
constexpr double kTexelsOfBake = 8;
/// They are larger if a level would have more of them than of the bake's and than this, ...
constexpr std::int64_t kFewTexels = 1 << 18;
/// ... or than this: each takes some 70 bytes.
constexpr std::int64_t kMostTexels = 1 << 22;

std::int64_t countTexels(const LitSurfaces& surfaces, const std::vector<LitMesh>& meshes) {
  std::int64_t texels = 0;
  for (const std::optional<LitSurface>& surface : surfaces)
    if (surface) texels += surface->texels.count();
  for (const LitMesh& mesh : meshes) texels += mesh.texels.count();
  return texels;
}

std::vector<std::uint32_t> allMeshes(const Level& level) {
  std::vector<std::uint32_t> meshes(level.meshes.size());
  std::iota(meshes.begin(), meshes.end(), 0U);
  return meshes;
}

/// The light of one of some sums, in levels.
Vec3 levelsOf(const TexelSums& sums, int i, int j, int samples) {
  const auto of = [&](int channel) {
    const int kept = sums.channels() == 1 ? 0 : channel;
    return sums.unitsInRow(kept, i, j, 1).front() / (samples * LightSum::kUnit);
  };
  return {of(0), of(1), of(2)};
}

/// All used texels whose samples count.
template <typename Places>
IrradianceMap mapOf(const Places& places, const TexelSums& sums, const BakeSettings& settings) {
  const UsedTexels texels(places.surface(), sums.rect());
  IrradianceMap map(places.surface(), sums.rect());
  for (int j = sums.rect().j0; j < sums.rect().j0 + sums.rect().height; ++j)
    texels.forEachRunIn(sums.rect(), j, [&](int first, int last) {
      for (int i = first; i <= last; ++i) map.set(i, j, levelsOf(sums, i, j, *settings.samples));
    });
  emptyTexelsOf(places, texels, settings).forEach([&](int i, int j) { map.leaveOut(i, j); });
  map.finish();
  return map;
}

}  // namespace

void LightOfPieces::add(const LightOfPieces& other) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(other.sums[i]);
}

std::int64_t IrradianceBake::Piece::texels(const LitSurfaces& surfaces) const {
  if (patch) return patch->surface.texels.count();
  return isOfMesh() ? texelsOfSmallFaces(faces) : surfaces[surface.index()]->texels.count();
}

IrradianceBake::IrradianceBake(const Scene& scene, const BakeSettings& settings, int threads)
    : scene_(scene), settings_(settings), threads_(threads) {
  // What reflects light is far larger than a texel, so one sample is enough for that.
  settings_.samples = 1;
  constexpr int kSoftSamples = 4;
  settings_.softSamples = std::min(settings.softSamples, kSoftSamples);
  const auto placeTexels = [&] {
    surfaces_ = makeLitSurfaces(scene, settings_.texel);
    meshes_ = makeLitMeshes(scene.level(), settings_.texel, threads);
    return countTexels(surfaces_, meshes_);
  };
  const std::int64_t most = std::clamp(placeTexels(), kFewTexels, kMostTexels);
  settings_.texel = std::max(kTexel, settings.texel / kTexelsOfBake);
  while (mistakeInTexel(scene, settings_.texel) || placeTexels() > most) settings_.texel *= 2;
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (surfaces_[i]) pieces_.push_back({SurfaceId(i), nullptr, {}});
  for (const LitMesh& mesh : meshes_) {
    for (const LitMesh::Patch& patch : mesh.patches) pieces_.push_back({mesh.surface, &patch, {}});
    for (const auto faces : smallFacesAtOnce(mesh))
      pieces_.push_back({mesh.surface, nullptr, faces});
  }
  std::ranges::stable_sort(pieces_, std::ranges::greater{},
                           [this](const Piece& piece) { return piece.texels(surfaces_); });
}

std::int64_t IrradianceBake::texels() const {
  std::int64_t texels = 0;
  for (const Piece& piece : pieces_) texels += piece.texels(surfaces_);
  return texels;
}

std::optional<LightOfPieces> IrradianceBake::lightOf(const Scene& scene,
                                                     const Irradiance* irradiance,
                                                     BakeProgress& progress,
                                                     const std::stop_token& stop) const {
  const LightVisibilities visibilities(scene, settings_, LightVisibilities::Purpose::Source,
                                       [irradiance] { return irradiance; });
  const MeshLighter meshes(scene, visibilities, settings_, threads_, allMeshes(scene.level()),
                           meshes_);
  std::vector<std::optional<TexelSums>> found(pieces_.size());
  parallelFor(pieces_.size(), threads_, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    found[i] = lightOf(pieces_[i], scene, visibilities, meshes, stop);
    progress.add(pieces_[i].texels(surfaces_));
  });
  if (stop.stop_requested()) return std::nullopt;
  LightOfPieces light;
  for (std::optional<TexelSums>& sums : found) light.sums.push_back(*std::move(sums));
  return light;
}

TexelSums IrradianceBake::lightOf(const Piece& piece, const Scene& scene,
                                  const LightVisibilities& visibilities, const MeshLighter& meshes,
                                  const std::stop_token& stop) const {
  if (!piece.isOfMesh()) {
    SurfaceLight surface(scene, surfaces_, visibilities, settings_.lambert, piece.surface);
    return sumsOfTile(surface, surface.surface().texels, settings_, stop);
  }
  const MeshPlace place = meshes.placeOf(scene.level().meshIndexOf(piece.surface));
  if (!piece.patch)
    return CornerLight(scene, visibilities, settings_.lambert, place).find(piece.faces);
  const LitSurfaces patch{piece.patch->surface};
  PatchLight lit(scene, visibilities, settings_.lambert, place, patch);
  return sumsOfTile(lit, lit.surface().texels, settings_, stop);
}

Irradiance IrradianceBake::irradiance(const LightOfPieces& light) const {
  const Level& level = scene_.level();
  const std::vector<std::vector<SectorId>> sectors = sectorsOfMeshes(level);
  Irradiance all(level, settings_.reflectance);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const TexelSums& sums = light.sums[i];
    if (!piece.isOfMesh()) {
      all.set(piece.surface,
              mapOf(SurfacePlaces(scene_, surfaces_, piece.surface), sums, settings_));
      continue;
    }
    const std::uint32_t mesh = level.meshIndexOf(piece.surface);
    const std::uint32_t firstFace = level.meshes[mesh].firstFace;
    if (piece.patch) {
      const LitSurfaces patch{piece.patch->surface};
      std::vector<std::uint32_t> faces = piece.patch->faces;
      for (std::uint32_t& face : faces) face += firstFace;
      all.setPatch(faces, mapOf(PatchPlaces(scene_, sectors[mesh], patch), sums, settings_));
      continue;
    }
    for (std::size_t k = 0; k < piece.faces.size(); ++k) {
      Vec3 sum;
      for (int corner = 0; corner < 3; ++corner)
        sum = sum + levelsOf(sums, corner, static_cast<int>(k), 1);
      all.setFace(firstFace + piece.faces[k].face, 1.0 / 3 * sum);
    }
  }
  return all;
}

}  // namespace hearth
