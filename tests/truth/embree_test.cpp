#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "edge_distance.h"
#include "embree_scene.h"
#include "load/load.h"
#include "math/box.h"
#include "peers/level_mesh.h"
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
  double farthest = 0;  ///< of the disagreements from an edge, as a fraction of the level's size
  std::array<int, kSurfaceKindCount> hits{};
};

/// Ray parameter at which a ray meets the plane of a triangle.
double meets(const MeshTriangle& triangle, Vec3 origin, Vec3 direction) {
  return dot(triangle.normal, triangle.corners[0] - origin) / dot(triangle.normal, direction);
}

/// One level in both tracers. Of Embree only the choice of the triangle is taken; where the ray
/// meets its plane is worked out in double precision, since single precision shifts a hit along a
/// plane that the ray grazes. The tracers agree on a ray when they choose the same surface and
/// their hits are no farther from each other than 1e-5 of the level's size. Where they do not, one
/// of them took a triangle that the other let the ray pass by: the ray must come that near to an
/// edge of what either of them hit.
class Comparison {
 public:
  /// `size` in metres.
  Comparison(std::string name, double size, const Scene& scene)
      : name_(std::move(name)), size_(size), scene_(scene), mesh_(meshOf(scene)) {}

  const std::vector<MeshTriangle>& mesh() const { return mesh_; }

  void compare(const RaySource::Sample& sample, Counts& counts) const {
    const Vec3 origin = RaySource::asDouble(sample.ray.origin);
    const Vec3 direction = RaySource::asDouble(sample.ray.direction);
    const auto hit = trace(scene_.level(), sample.sector, origin, direction, RayKind::Look);
    ASSERT_TRUE(hit.has_value());
    ++counts.rays;
    ++counts.hits[static_cast<std::size_t>(hit->kind)];
    const MeshTriangle* met = embree_.firstMet(sample.ray);
    const double other = met ? meets(*met, origin, direction) : kNever;
    const double apart = std::abs(hit->t - other) * length(direction);
    if (met && isOn(*met, *hit) && apart <= kNear * size_) return;
    ++counts.disagreements;
    const double toEdge = distanceToEdges(*hit, met, origin, direction);
    counts.farthest = std::max(counts.farthest, toEdge / size_);
    if (toEdge <= kNear * size_)
      ++counts.nearEdges;
    else
      ADD_FAILURE() << name_ << ": from " << origin.x << ' ' << origin.y << ' ' << origin.z
                    << " along " << direction.x << ' ' << direction.y << ' ' << direction.z
                    << ": truth " << name(hit->kind) << " at " << hit->t << ", Embree "
                    << (met ? name(scene_[met->surface].kind) : "nothing") << " at " << other
                    << ", metres from their edges: " << toEdge;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kNear = 1e-5;  ///< fraction of the level's size

  /// Metres from the ray, as far as twice the way to truth's hit, to the nearest edge of the
  /// triangle that Embree hit and of those of the surface that truth hit.
  double distanceToEdges(const TruthHit& hit, const MeshTriangle* met, Vec3 origin,
                         Vec3 direction) const {
    double nearest = kNever;
    for (const MeshTriangle& triangle : mesh_)
      if (&triangle == met || isOn(triangle, hit))
        nearest =
            std::min(nearest, distanceToEdge(triangle, origin, origin + 2 * hit.t * direction));
    return nearest;
  }

  bool isOn(const MeshTriangle& triangle, const TruthHit& hit) const {
    const Surface& surface = scene_[triangle.surface];
    return surface.kind == hit.kind && surface.sector == hit.sector &&
           surface.segment == hit.segment;
  }

  std::string name_;
  double size_;  ///< metres
  Scene scene_;
  std::vector<MeshTriangle> mesh_;
  EmbreeScene embree_{mesh_};
};

void print(const Counts& counts) {
  std::printf("%d rays, %d disagreements, %d of them near edges: none farther than %.1e sizes\n",
              counts.rays, counts.disagreements, counts.nearEdges, counts.farthest);
}

std::vector<TestScene> allScenes() {
  std::vector<TestScene> scenes;
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
  for (TestScene& made : allScenes()) {
    made.level.finished();
    const Comparison comparison(made.name, made.size, made.level.scene());
    RaySource source(made.level.scene(), ++seed);
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
  for (std::size_t i = 0; i < kSurfaceKindCount; ++i) {
    const auto kind = static_cast<SurfaceKind>(i);
    if (isThing(kind)) continue;  // the scenes have none
    EXPECT_GT(counts.hits[i], 50) << name(kind);
  }
}

TEST(TruthAgainstEmbree, RaysAimedAtEdgesDifferOnlyThere) {
  const Counts counts = compareAll(
      25'000, [](RaySource& source, const auto& mesh) { return source.atAnEdgeOf(mesh); });
  EXPECT_EQ(counts.disagreements, counts.nearEdges);
}

/// Metres, of the longest side of the level's box.
double sizeOf(const Level& level) {
  Box box;
  for (const Sector& sector : level.sectors) box = join(box, sector.box);
  return box.longerSide();
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
    Level level = result.loaded->level;
    level.holes.clear();  // Embree's triangles have none
    const Scene scene(level, result.loaded->geometry);
    const Comparison comparison(random.name, sizeOf(level), scene);
    RaySource source(scene, seed);
    for (int i = 0; i < 1000; ++i) {
      comparison.compare(source.anywhere(), counts);
      comparison.compare(source.atAnEdgeOf(comparison.mesh()), counts);
    }
  }
  std::filesystem::remove_all(folder);
  print(counts);
  EXPECT_GT(counts.rays, 400'000);
  EXPECT_EQ(counts.disagreements, counts.nearEdges);
}

}  // namespace
}  // namespace hearth
