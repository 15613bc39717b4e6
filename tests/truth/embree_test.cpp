#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "embree_mesh.h"
#include "embree_scene.h"
#include "load/load.h"
#include "random_levels/random_level.h"
#include "ray_source.h"
#include "scenes.h"
#include "truth/trace.h"

namespace hearth {
namespace {

struct Counts {
  int rays = 0;
  int disagreements = 0;
  int nearEdges = 0;
  int grazing = 0;  ///< in one plane, along which single precision shifts the hit
  std::array<int, kSurfaceKinds> hits{};
};

/// One level in both tracers. They agree on a ray when their hits are nearer to each other than
/// 1e-5 of the level's size. Where they do not, an edge must be that near to the ray at the first
/// hit or just behind it; or Embree's hit must be that near to the plane which truth met, and on a
/// triangle in it, along which the ray grazes and single precision shifts the hit.
class Comparison {
 public:
  /// `size` in metres.
  Comparison(std::string name, double size, const Level& level)
      : name_(std::move(name)), size_(size), level_(level), mesh_(meshOf(level)) {}

  const std::vector<MeshTriangle>& mesh() const { return mesh_; }

  void compare(const RaySource::Sample& sample, Counts& counts) const {
    const Vec3 origin = RaySource::asDouble(sample.ray.origin);
    const Vec3 direction = RaySource::asDouble(sample.ray.direction);
    const auto hit = trace(level_, sample.sector, origin, direction, RayKind::Look);
    ASSERT_TRUE(hit.has_value());
    ++counts.rays;
    ++counts.hits[static_cast<std::size_t>(hit->kind)];
    const EmbreeScene::Hit other = scene_.trace(sample.ray);
    if (std::abs(hit->t - other.t) * length(direction) <= 1e-5 * size_) return;
    ++counts.disagreements;
    const auto [near, far] = std::minmax(hit->t, other.t);
    const double toEdge = distanceToEdge(mesh_, origin + near * direction,
                                         origin + std::min(far, 1.001 * near) * direction);
    if (toEdge <= 1e-5 * size_)
      ++counts.nearEdges;
    else if (isGrazing(*hit, other, direction))
      ++counts.grazing;
    else
      ADD_FAILURE() << name_ << ": from " << origin.x << ' ' << origin.y << ' ' << origin.z
                    << " along " << direction.x << ' ' << direction.y << ' ' << direction.z
                    << ": truth " << name(hit->kind) << " at " << hit->t << ", Embree at "
                    << other.t << " (" << surfaceName(other)
                    << "), metres from an edge: " << toEdge;
  }

 private:
  bool isGrazing(const TruthHit& hit, const EmbreeScene::Hit& other, Vec3 direction) const {
    const auto toPlane = [&](Vec3 p) { return std::abs(dot(hit.normal, p - hit.point)); };
    return other.triangle < mesh_.size() &&
           std::ranges::all_of(mesh_[other.triangle].corners,
                               [&](Vec3 corner) { return toPlane(corner) <= 1e-6 * size_; }) &&
           toPlane(hit.point + (other.t - hit.t) * direction) <= 1e-5 * size_;
  }

  std::string_view surfaceName(const EmbreeScene::Hit& hit) const {
    if (hit.triangle >= mesh_.size()) return "nothing";
    return name(level_[mesh_[hit.triangle].surface].kind);
  }

  std::string name_;
  double size_;  ///< metres
  const Level& level_;
  std::vector<MeshTriangle> mesh_;
  EmbreeScene scene_{mesh_};
};

void print(const Counts& counts) {
  std::printf("%d rays, %d disagreements: %d near edges, %d grazing\n", counts.rays,
              counts.disagreements, counts.nearEdges, counts.grazing);
}

std::vector<Scene> allScenes() {
  std::vector<Scene> scenes;
  scenes.push_back(yardScene());
  for (std::uint64_t seed = 1; seed <= 4; ++seed) scenes.push_back(storeysScene(seed));
  for (std::uint64_t seed = 1; seed <= 15; ++seed) scenes.push_back(gridScene(seed));
  return scenes;
}

/// Compares `raysPerLevel` rays of `next(source, mesh)` in each level.
template <typename NextRay>
Counts compareAll(int raysPerLevel, NextRay next) {
  Counts counts;
  std::uint64_t seed = 0;
  for (Scene& made : allScenes()) {
    const Level& level = made.level.finished();
    const Comparison comparison(made.name, made.size, level);
    RaySource source(level, ++seed);
    for (int i = 0; i < raysPerLevel; ++i)
      comparison.compare(next(source, comparison.mesh()), counts);
  }
  print(counts);
  return counts;
}

TEST(TruthAgainstEmbree, AMillionRaysEndAtTheSamePlaces) {
  const Counts counts =
      compareAll(50'000, [](RaySource& source, const auto&) { return source.anywhere(); });
  EXPECT_EQ(counts.rays, 1'000'000);
  EXPECT_EQ(counts.disagreements, counts.nearEdges);
  EXPECT_LT(counts.disagreements, 100);
  for (std::size_t kind = 0; kind < kSurfaceKinds; ++kind)
    EXPECT_GT(counts.hits[kind], 50) << name(static_cast<SurfaceKind>(kind));
}

TEST(TruthAgainstEmbree, RaysAimedAtEdgesDifferOnlyThere) {
  const Counts counts = compareAll(
      25'000, [](RaySource& source, const auto& mesh) { return source.atAnEdgeOf(mesh); });
  EXPECT_EQ(counts.disagreements, counts.nearEdges + counts.grazing);
}

/// Metres, of the longest side of the level's box.
double sizeOf(const Level& level) {
  Vec2 min = level.sectors.front().boxMin;
  Vec2 max = level.sectors.front().boxMax;
  for (const Sector& sector : level.sectors) {
    min = {std::min(min.x, sector.boxMin.x), std::min(min.y, sector.boxMin.y)};
    max = {std::max(max.x, sector.boxMax.x), std::max(max.y, sector.boxMax.y)};
  }
  return std::max(max.x - min.x, max.y - min.y);
}

TEST(TruthAgainstEmbree, RaysInRandomLevelsEndAtTheSamePlaces) {
  const std::filesystem::path folder = testing::TempDir() + "truth_embree_levels";
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures").has_value());
  Counts counts;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const RandomLevel random = makeRandomLevel(seed);
    // Embree knows positions only, and would see both of two sectors in one place.
    if (random.features.contains(Feature::OverlappingSectors)) continue;
    ASSERT_TRUE(writeRandomLevel(folder, random).has_value());
    const LoadResult result = loadLevel(folder / (random.name + ".json"));
    ASSERT_TRUE(result.loaded.has_value()) << random.name;
    const Level& level = result.loaded->level;
    const Comparison comparison(random.name, sizeOf(level), level);
    RaySource source(level, seed);
    for (int i = 0; i < 1000; ++i) {
      comparison.compare(source.anywhere(), counts);
      comparison.compare(source.atAnEdgeOf(comparison.mesh()), counts);
    }
  }
  std::filesystem::remove_all(folder);
  print(counts);
  EXPECT_GT(counts.rays, 400'000);
  EXPECT_EQ(counts.disagreements, counts.nearEdges + counts.grazing);
}

}  // namespace
}  // namespace hearth
