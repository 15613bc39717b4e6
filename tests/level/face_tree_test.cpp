// Faces of meshes as rays meet them, and the hierarchy that finds them.

#include "level/face_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "level/face_ray.h"

namespace hearth {
namespace {

MeshFace face(Vec3 a, Vec3 b, Vec3 c) { return {{a, b, c}, {}, TextureId(0)}; }

class Random {
 public:
  double number(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3 point(double size) {
    const double x = number(-size, size);
    const double y = number(-size, size);
    return {x, y, number(-size, size)};
  }

 private:
  std::mt19937_64 engine_{7};
};

std::vector<MeshFace> randomFaces(int count, double size) {
  Random random;
  std::vector<MeshFace> faces;
  for (int i = 0; i < count; ++i) {
    const Vec3 at = random.point(10);
    faces.push_back(
        face(at + random.point(size), at + random.point(size), at + random.point(size)));
  }
  return faces;
}

/// A ball of triangles around the origin, with a radius of 1 m, their fronts outside.
std::vector<MeshFace> ball(int around) {
  const int down = around / 2;
  const auto at = [&](int i, int j) -> Vec3 {
    if (j == 0 || j == down) return {0, 0, j == 0 ? 1.0 : -1.0};
    const double turn = 2 * M_PI * (i % around) / around;
    const double fall = M_PI * j / down;
    return {std::sin(fall) * std::cos(turn), std::sin(fall) * std::sin(turn), std::cos(fall)};
  };
  std::vector<MeshFace> faces;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < down; ++j) {
      if (j > 0) faces.push_back(face(at(i, j), at(i + 1, j), at(i, j + 1)));
      if (j + 1 < down) faces.push_back(face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)));
    }
  return faces;
}

std::set<std::uint32_t> metByTree(const FaceTree& tree, const std::vector<MeshFace>& faces,
                                  const FaceRay& ray) {
  std::set<std::uint32_t> met;
  tree.anyFaceOn(tree.boxRay(ray, 0, 1), [&](std::uint32_t i) {
    const auto crossing = ray.crossingOf(faces[i]);
    if (crossing && crossing->t >= 0 && crossing->t <= 1) met.insert(i);
    return false;
  });
  return met;
}

std::set<std::uint32_t> metOfAll(const std::vector<MeshFace>& faces, const FaceRay& ray) {
  std::set<std::uint32_t> met;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    const auto crossing = ray.crossingOf(faces[i]);
    if (crossing && crossing->t >= 0 && crossing->t <= 1) met.insert(i);
  }
  return met;
}

TEST(FaceTree, leadsRaysToEachFaceThatTheyMeet) {
  for (const double size : {0.01, 1.0, 8.0}) {
    const std::vector<MeshFace> faces = randomFaces(500, size);
    const FaceTree tree(faces);
    Random random;
    std::size_t met = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec3 origin = random.point(12);
      const MeshFace& aim = faces[static_cast<std::size_t>(i)];
      const Vec3 middle = (1.0 / 3) * (aim.corners[0] + aim.corners[1] + aim.corners[2]);
      const FaceRay ray(origin, 2 * (middle - origin));
      const std::set<std::uint32_t> all = metOfAll(faces, ray);
      EXPECT_EQ(metByTree(tree, faces, ray), all);
      met += all.size();
    }
    EXPECT_GE(met, 490U);
  }
}

std::optional<FaceRay::Crossing> nearestOfAll(const std::vector<MeshFace>& faces,
                                              const FaceRay& ray, double tFrom, double tTo) {
  std::optional<FaceRay::Crossing> nearest;
  for (const MeshFace& each : faces) {
    const auto crossing = ray.crossingOf(each);
    if (!crossing || crossing->t < tFrom || crossing->t > tTo || crossing->t <= 0) continue;
    if (!nearest || crossing->t < nearest->t) nearest = crossing;
  }
  return nearest;
}

TEST(FaceTree, saysWhetherAnyFaceStopsAPartOfARayAndWhichIsTheNearest) {
  const std::vector<MeshFace> faces = randomFaces(500, 2);
  const FaceTree tree(faces);
  Random random;
  int stopped = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 origin = random.point(12);
    const FaceRay ray(origin, random.point(12) - origin);
    const double tFrom = random.number(-0.5, 0.5);
    const double tTo = random.number(0.2, 1);
    const auto expected = nearestOfAll(faces, ray, tFrom, tTo);
    EXPECT_EQ(tree.stops(faces, ray, tFrom, tTo), expected.has_value());
    const auto found = tree.nearest(faces, ray, tFrom, tTo, 0);
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!found) continue;
    EXPECT_EQ(found->t, expected->t);
    EXPECT_EQ(found->isFront, expected->isFront);
    ++stopped;
  }
  EXPECT_GT(stopped, 200);
  EXPECT_LT(stopped, 1800);
}

/// A front, and a back so much farther along the ray, among others that are farther still.
TEST(FaceTree, takesBacksThatTouchAFrontForNearer) {
  constexpr double kTie = 1e-3;
  const auto levelAt = [](double z, bool isFront) {
    const Vec3 a{0, 0, z};
    const Vec3 b{1, 0, z};
    const Vec3 c{0, 1, z};
    return isFront ? face(a, c, b) : face(a, b, c);
  };
  const FaceRay ray({0.2, 0.2, 1}, {0, 0, -1});
  ASSERT_TRUE(ray.crossingOf(levelAt(0, true))->isFront);
  for (const double apart : {-1e-2, 0.0, 0.9e-3, 1.1e-3})
    for (const bool isBackLast : {false, true}) {
      std::vector<MeshFace> faces(40, levelAt(-1, true));
      faces.push_back(levelAt(isBackLast ? 0.5 : 0.5 - apart, isBackLast));
      faces.push_back(levelAt(isBackLast ? 0.5 - apart : 0.5, !isBackLast));
      const auto nearest = FaceTree(faces).nearest(faces, ray, 0, 1, kTie);
      ASSERT_TRUE(nearest);
      EXPECT_EQ(nearest->isFront, apart > kTie) << apart << ' ' << isBackLast;
    }
}

TEST(FaceTree, findsFacesFarFromTheOriginInBoxesThatHoldThem) {
  const Vec3 far{1e6 + 0.1, -3e5, 7e4 / 3};
  std::vector<MeshFace> faces = randomFaces(300, 0.01);
  for (MeshFace& each : faces)
    for (Vec3& corner : each.corners) corner = 0.001 * corner + far;
  const FaceTree tree(faces);
  const auto isIn = [](Vec3 p, const Box3& box) {
    Box3 grown = box;
    grown.add(p);
    return grown == box;
  };
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    for (const Vec3 corner : faces[i].corners) {
      EXPECT_TRUE(isIn(corner, tree.box()));
      EXPECT_TRUE(tree.anyFace([&](const Box3& box) { return isIn(corner, box); },
                               [i](std::uint32_t found) { return found == i; }));
    }
    const Vec3 middle =
        (1.0 / 3) * (faces[i].corners[0] + faces[i].corners[1] + faces[i].corners[2]);
    const FaceRay ray(middle - Vec3{20, 30, 40}, {40, 60, 80});
    EXPECT_EQ(metByTree(tree, faces, ray), metOfAll(faces, ray));
  }
}

/// Of rays between random points, how many faces are asked on average.
double askedByRays(const std::vector<MeshFace>& faces) {
  constexpr int kRays = 1000;
  const FaceTree tree(faces);
  Random random;
  int asked = 0;
  for (int i = 0; i < kRays; ++i) {
    const Vec3 from = random.point(10);
    tree.anyFaceOn(tree.boxRay(FaceRay(from, random.point(10) - from), 0, 1), [&](std::uint32_t) {
      ++asked;
      return false;
    });
  }
  return static_cast<double>(asked) / kRays;
}

TEST(FaceTree, asksFewFacesAlsoWhereTheyLeaveGaps) {
  EXPECT_LT(askedByRays(randomFaces(20000, 0.05)), 20);
  std::vector<MeshFace> clusters = randomFaces(20000, 0.05);
  for (MeshFace& each : clusters) {
    const Vec3 at = each.corners[0];
    const Vec3 cluster{std::round(at.x / 5) * 5, std::round(at.y / 5) * 5,
                       std::round(at.z / 5) * 5};
    for (Vec3& corner : each.corners) corner = cluster + 0.1 * (corner - cluster);
  }
  EXPECT_LT(askedByRays(clusters), 2);
}

TEST(FaceTree, leadsRaysAlongAxesToFacesInThePlanesOfTheirBoxes) {
  std::vector<MeshFace> faces;
  for (int i = 0; i < 40; ++i) {
    const double x = i;
    faces.push_back(face({x, -1, -1}, {x, 1, -1}, {x, 0, 1}));
  }
  const FaceTree tree(faces);
  const FaceRay through({-1, 0, 0}, {50, 0, 0});
  EXPECT_EQ(metByTree(tree, faces, through).size(), 40U);
  const FaceRay alongTheBottom({-1, 0, -1}, {50, 0, 0});
  EXPECT_EQ(metByTree(tree, faces, alongTheBottom).size(), 40U) << "edges belong to faces";
  const FaceRay beside({-1, 0, -1.0000001}, {50, 0, 0});
  EXPECT_EQ(metByTree(tree, faces, beside).size(), 0U);
}

TEST(FaceTree, holdsFacesAtOnePlaceAndOfAllSizes) {
  const std::vector<MeshFace> same(1000, face({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_EQ(metByTree(FaceTree(same), same, FaceRay({0.2, 0.2, 1}, {0, 0, -2})).size(), 1000U);
  std::vector<MeshFace> shrinking;
  for (double size = 1e300; size > 1e-300; size /= 2)
    shrinking.push_back(face({0, 0, 0}, {size, 0, 0}, {0, size, 0}));
  const FaceTree tree(shrinking);
  const FaceRay ray({0.25, 0.25, 1}, {0, 0, -2});
  EXPECT_EQ(metByTree(tree, shrinking, ray), metOfAll(shrinking, ray));
  EXPECT_GE(metOfAll(shrinking, ray).size(), 500U) << "up to where squares are too large";
}

TEST(FaceTree, holdsFacesThatShrinkTowardsAPoint) {
  std::vector<MeshFace> faces;
  for (double x = 0x1p100; x > 0x1p-100; x /= 2)
    for (const double at : {-x, x})
      faces.push_back(face({at, -at, -at}, {at, at, -at}, {at, 0, at}));
  const FaceTree tree(faces);
  const FaceRay alongAll({-0x1p101, 0, 0}, {0x1p102, 0, 0});
  EXPECT_EQ(metByTree(tree, faces, alongAll).size(), faces.size());
  for (const MeshFace& aim : faces) {
    const Vec3 from{0, aim.corners[1].y, 0};
    const FaceRay ray(from, 2 * (aim.corners[2] - from));
    EXPECT_EQ(metByTree(tree, faces, ray), metOfAll(faces, ray));
  }
}

TEST(FaceRay, findsNoGapBetweenFacesThatShareCorners) {
  const std::vector<MeshFace> faces = ball(40);
  const FaceTree tree(faces);
  Random random;
  for (const MeshFace& aim : faces)
    for (std::size_t k = 0; k < 3; ++k)
      for (const double along : {0.0, 0.3, 0.5}) {
        const Vec3 from = aim.corners[k];
        const Vec3 onEdge = from + along * (aim.corners[(k + 1) % 3] - from);
        const Vec3 inside = random.point(0.5);
        EXPECT_FALSE(metByTree(tree, faces, FaceRay(inside, 1.5 * (onEdge - inside))).empty());
      }
}

TEST(FaceRay, tellsTheFrontOfAFaceFromItsBack) {
  const std::vector<MeshFace> faces = ball(16);
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.point(0.5);
    const Vec3 far = 4 * random.point(1);
    if (length(far) < 1.5) continue;
    const FaceRay outwards(p, far - p);
    const FaceRay inwards(far, p - far);
    for (const MeshFace& met : faces) {
      if (const auto crossing = outwards.crossingOf(met); crossing && crossing->t > 0) {
        EXPECT_FALSE(crossing->isFront);
      }
      if (const auto crossing = inwards.crossingOf(met); crossing && crossing->t < 1) {
        EXPECT_TRUE(crossing->isFront);
      }
    }
  }
}

TEST(FaceRay, meetsNoFaceThatItSeesEdgeOnNorAlongNothing) {
  const MeshFace level = face({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_FALSE(FaceRay({-1, 0.2, 0}, {3, 0, 0}).crossingOf(level));
  EXPECT_FALSE(FaceRay({0.2, 0.2, 0}, {0, 0, 0}).crossingOf(level));
  const auto crossing = FaceRay({0.2, 0.2, 1}, {0, 0, -4}).crossingOf(level);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->t, 0.25);
}

}  // namespace
}  // namespace hearth
