#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "test_level.h"
#include "truth/depth.h"
#include "truth/truth_meshes.h"

namespace hearth {
namespace {

class Random {
 public:
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(bits_); }
  Vec3 inCube(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  /// Of any order of magnitude between these.
  double sizeBetween(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }

 private:
  std::mt19937_64 bits_{1};
};

/// A two-sided mesh alone in a sector.
class LoneMesh {
 public:
  LoneMesh() {
    TestLevel test;
    test.addBox("box", {0, 0}, {1, 1}, {0, 1});
    level_ = test.finished();
    level_.meshes.resize(1);
    level_.meshes[0].sector = SectorId(0);
    level_.meshes[0].isTwoSided = true;
  }
  std::optional<TruthHit> meet(const std::vector<MeshFace>& faces, Vec3 origin, Vec3 direction) {
    level_.meshFaces = faces;
    level_.meshes[0].faceCount = static_cast<std::uint32_t>(faces.size());
    return TruthMeshes(level_).nearest(origin, direction, {SectorId(0), 0, kNever});
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  Level level_;
};

/// 1 m deep before a camera that looks along x.
Vec3 anyDirection(Random& random) { return {1, random.between(-1, 1), random.between(-0.8, 0.8)}; }

/// How far from edge-on the ray sees the face: the sine of the angle between them.
double steepness(const MeshFace& face, Vec3 direction) {
  const Vec3 normal = frontOf(face);
  return std::abs(dot(normal, direction)) / length(normal) / length(direction);
}

TEST(TruthMeshes, AreMetAtTheDepthOfTheirFacesHoweverLargeOrSmall) {
  Random random;
  LoneMesh mesh;
  int met = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 origin = random.inCube(100);
    const Vec3 direction = anyDirection(random);
    const double depth = random.sizeBetween(0.01, 1000);
    const double size = random.sizeBetween(1e-6, 1e6);
    // Corners around the point, whose weighted mean it is.
    std::array<double, 3> weights{};
    for (double& weight : weights) weight = random.between(0.05, 1);
    std::array<Vec3, 3> corners{random.inCube(size), random.inCube(size), {}};
    corners[2] = (-1 / weights[2]) * (weights[0] * corners[0] + weights[1] * corners[1]);
    for (Vec3& corner : corners) corner = origin + depth * direction + corner;
    const MeshFace face{corners, {Vec2{1, 0}, {0, 1}, {0, 0}}, {}};
    const double thinnest = length(frontOf(face)) / (size * size);
    if (steepness(face, direction) < 0.05 || thinnest < 0.05) continue;

    const auto hit = mesh.meet({face}, origin, direction);
    ASSERT_TRUE(hit) << i;
    ++met;
    ASSERT_LT(std::abs(hit->t - depth), 0.1 * depthTie(depth)) << i << ' ' << size << ' ' << depth;
    const double sum = weights[0] + weights[1] + weights[2];
    const double noise = 1e-9 + 1e-11 * (1 + depth) / size;  // of coordinates, by the face's size
    ASSERT_NEAR(hit->imageMetres.x, weights[0] / sum, noise) << i;
    ASSERT_NEAR(hit->imageMetres.y, weights[1] / sum, noise) << i;
  }
  EXPECT_GT(met, 10'000);
}

TEST(TruthMeshes, LeaveNoGapWhereFacesMeet) {
  Random random;
  LoneMesh mesh;
  constexpr int kSpokes = 7;
  for (int i = 0; i < 5'000; ++i) {
    const double size = random.sizeBetween(1e-3, 100);
    const Vec3 hub{random.between(1, 50), random.between(-20, 20), random.between(-20, 20)};
    std::vector<Vec3> rim;
    for (int k = 0; k < kSpokes; ++k) {
      const double turn = 2 * std::acos(-1) * (k + random.between(0, 0.5)) / kSpokes;
      const double radius = size * random.between(0.5, 1);
      rim.push_back(hub + Vec3{random.between(-0.02, 0.02) * size, radius * std::cos(turn),
                               radius * std::sin(turn)});
    }
    std::vector<MeshFace> faces;
    for (int k = 0; k < kSpokes; ++k)
      faces.push_back({{hub, rim[static_cast<std::size_t>(k)],
                        rim[static_cast<std::size_t>((k + 1) % kSpokes)]},
                       {},
                       {}});
    const Vec3 origin{0, random.between(-1, 1), random.between(-1, 1)};
    const Vec3 end = rim[static_cast<std::size_t>(i % kSpokes)];
    const Vec3 target = hub + (i % 3 ? random.between(0, 0.9) : 0) * (end - hub);
    const Vec3 direction = (1 / target.x) * (target - origin);
    const auto hit = mesh.meet(faces, origin, direction);
    ASSERT_TRUE(hit) << i;
    ASSERT_NEAR(hit->t, target.x, 1e-10) << i;
  }
}

TEST(TruthMeshes, AreMetBetweenTheDepthsOfTheirCornersHoweverThin) {
  Random random;
  LoneMesh mesh;
  int met = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 a{random.between(1, 2), random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
    const Vec3 b = 2 * a + random.inCube(0.1);
    const Vec3 c =
        a + random.between(0, 1) * (b - a) + random.inCube(random.sizeBetween(1e-17, 1e-9));
    const Vec3 target = a + random.between(0, 1) * (b - a);
    const auto hit = mesh.meet({{{a, b, c}, {}, {}}}, {}, (1 / target.x) * target);
    if (!hit) continue;
    ++met;
    ASSERT_GE(hit->t, std::min(a.x, c.x) - 1e-14);
    ASSERT_LE(hit->t, std::max(b.x, c.x) + 1e-14);
    ASSERT_NEAR(length(hit->normal), 1, 1e-12);
  }
  EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace hearth
