#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "adjoining_rooms.h"
#include "lit_hall.h"
#include "mesh_shapes.h"
#include "truth/truth_light.h"
#include "truth/truth_view.h"

namespace hearth {
namespace {

TEST(TruthMeshLight, FallsOffWithDistance) {
  LitHall scene;
  scene.addCube({3.5, 3.5});
  scene.light({4, 4, 3}, 200, 0.5);
  const Level& level = scene.test.finished();
  EXPECT_NEAR(levelAt(level, facePoint(level, 0, kBoxTop, {4, 4, 1})), 200 / (2 * 0.5 + 1), 1e-12);
  EXPECT_NEAR(levelAt(level, facePoint(level, 0, kBoxTop, {3.6, 4.3, 1})),
              200 / (std::hypot(0.4, 0.3, 2) * 0.5 + 1), 1e-12);
}

TEST(TruthMeshLight, IsMultipliedByTheCosineAtTheFaceWithLambert) {
  LitHall scene;
  scene.addCube({3.5, 3.5});
  scene.light({6, 4, 3});
  Level level = scene.test.finished();
  const SurfacePoint top = facePoint(level, 0, kBoxTop, {4, 4, 1});
  EXPECT_NEAR(levelAt(level, top), 100, 1e-12);
  level.bake.lambert = true;
  EXPECT_NEAR(levelAt(level, top), 100 / std::sqrt(2), 1e-12);
  // A face whose front is turned by 30 degrees from the light's direction.
  const double slope = std::tan(std::acos(-1) / 6);
  LitHall roof;
  roof.add(polygonOf({{3, 3, 1 - slope}, {3, 5, 1 - slope}, {5, 5, 1 + slope}, {5, 3, 1 + slope}},
                     roof.image));
  roof.light({4, 4, 3});
  Level roofed = roof.test.finished();
  roofed.bake.lambert = true;
  EXPECT_NEAR(levelAt(roofed, facePoint(roofed, 0, 0, {4, 4, 1})), 100 * std::sqrt(0.75), 1e-12);
}

TEST(TruthMeshLight, IsMultipliedByColour) {
  LitHall scene;
  scene.addCube({3.5, 3.5});
  scene.light({4, 4, 3}, 255);
  Level level = scene.test.finished();
  std::ranges::copy(std::array<std::uint8_t, 3>{255, 51, 0}, level.lights[0].color);
  const Vec3 levels = TruthLight(level).at(facePoint(level, 0, kBoxTop, {4, 4, 1}));
  EXPECT_NEAR(levels.x, 255, 1e-12);
  EXPECT_NEAR(levels.y, 51, 1e-12);
  EXPECT_NEAR(levels.z, 0, 1e-12);
}

TEST(TruthMeshLight, OfAFaceIsThatOfItsFrontFromWhicheverSideItIsSeen) {
  LitHall scene;
  scene.add(tableAt(1, {3, 3}, {5, 5}, scene.image)).isTwoSided = true;
  scene.light({4, 4, 3}, 100);
  scene.light({4, 4, 0.5}, 7);
  Level level = scene.test.finished();
  level.bake.lambert = true;
  SurfacePoint place = facePoint(level, 0, 0, {3.5, 4, 1});
  const double fromAbove = 100 * 2 / std::hypot(0.5, 2);
  EXPECT_NEAR(levelAt(level, place), fromAbove, 1e-12);
  place.normal = -1 * place.normal;
  EXPECT_NEAR(levelAt(level, place), fromAbove, 1e-12);
}

TEST(TruthMeshLight, LeavesTheBacksOfFacesDark) {
  for (const bool isTwoSided : {false, true}) {
    LitHall scene;
    scene.add(turnedOver(tableAt(1, {3, 3}, {5, 5}, scene.image))).isTwoSided = isTwoSided;
    scene.light({4, 4, 3});
    const Level& level = scene.test.finished();
    EXPECT_EQ(levelAt(level, facePoint(level, 0, 0, {3.5, 4, 1})), 0);
  }
}

TEST(TruthMeshLight, IsNoneInThePlaneOfAFace) {
  for (const double above : {0.9e-6, 1.1e-6}) {
    LitHall scene;
    scene.add(tableAt(1, {3, 3}, {5, 5}, scene.image));
    scene.light({7, 4, 1 + above});
    const Level& level = scene.test.finished();
    EXPECT_EQ(levelAt(level, facePoint(level, 0, 0, {4, 4, 1})), above > 1e-6 ? 100 : 0);
  }
}

TEST(TruthMeshLight, OfABallComesFromWhatOfItLiesBeforeTheFace) {
  LitHall scene;
  scene.add(tableAt(3, {1, 1}, {2, 2}, scene.image));
  scene.light({4, 4, 3}).radius = 0.5;
  const Level& level = scene.test.finished();
  EXPECT_NEAR(TruthLight(level).seenFraction(0, facePoint(level, 0, 0, {1.5, 1.5, 3})), 0.5, 0.004);
}

TEST(TruthMeshLight, DoesNotReachWhatAWallHides) {
  TestLevel test;
  const SectorId room = test.addSector("room", {});
  test.addLoop(room, {{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  test.addLoop(room, {{4, 3}, {4, 5}, {5, 5}, {5, 3}});  // a pillar
  test.addMesh(room, "table", tableAt(1, {5.5, 0.5}, {7.5, 7.5}, test.texture().texture));
  test.addLight(room, {2, 4, 2}, 100);
  const Level& level = test.finished();
  // Beside the pillar's corner (4, 3), 1 m aside and 2 m ahead of the light.
  EXPECT_EQ(levelAt(level, facePoint(level, 0, 0, {6, 2 + 1e-9, 1})), 0);
  EXPECT_EQ(levelAt(level, facePoint(level, 0, 0, {6, 2 - 1e-9, 1})), 100);
}

TEST(TruthMeshLight, IsShadowedByOtherPartsOfTheMesh) {
  LitHall scene;  // an L: a shelf 1 m high, and on its edge a back that reaches up to 2 m
  scene.add(joined(tableAt(1, {4, 3}, {7, 5}, scene.image),
                   boardAcrossX(4, {3, 1}, {5, 2}, scene.image)));
  scene.light({3, 4, 3});
  const Level& level = scene.test.finished();
  const auto onShelf = [&](double x) { return levelAt(level, facePoint(level, 0, 0, {x, 4, 1})); };
  // Over the back's upper edge, 1 m ahead and 1 m down, 2 m down: up to x = 5.
  EXPECT_EQ(onShelf(4 + 1e-6), 0) << "in the corner";
  EXPECT_EQ(onShelf(5 - 1e-9), 0);
  EXPECT_EQ(onShelf(5 + 1e-9), 100);
  EXPECT_EQ(levelAt(level, facePoint(level, 0, 2, {4, 4, 1})), 100) << "the back's foot";
  EXPECT_EQ(levelAt(level, facePoint(level, 0, 3, {4, 4, 2})), 100) << "the back's upper edge";
}

TEST(TruthMeshLight, ReachesMeshesWhereTheyTouchTheLevelAndOneAnother) {
  LitHall scene;
  scene.addCube({7, 3});  // at the east wall, on the floor
  scene.add(boxOf({7, 3, 1}, {8, 4, 2}, scene.image));
  scene.light({2, 1, 1.5});
  const Level& level = scene.test.finished();
  constexpr std::uint32_t kWest = 0;
  constexpr std::uint32_t kNorth = 4;
  for (const Vec3 p : {Vec3{7, 3.5, 0}, {7, 3, 0}, {7, 4, 0}, {7, 3.5, 1}})
    EXPECT_EQ(levelAt(level, facePoint(level, 0, kWest, p)), 100) << p.y << ' ' << p.z;
  for (const Vec3 p : {Vec3{8, 3, 0.5}, {8, 3, 0}, {8, 3, 1}})
    EXPECT_EQ(levelAt(level, facePoint(level, 0, kNorth, p)), 100) << p.x << ' ' << p.z;
  EXPECT_EQ(levelAt(level, facePoint(level, 0, kBoxTop, {7.5, 3.5, 1})), 0) << "between the two";
  EXPECT_EQ(levelAt(level, facePoint(level, 1, kWest, {7, 3.5, 1})), 100);
}

TEST(TruthMeshLight, ReachesTheEdgeOfAMeshAtAWallWhateverTheRounding) {
  TestLevel test;
  const SectorId room = test.addSector("room", {});
  test.addLoop(room, {{0, 0}, {8, 0}, {5, 8}, {0, 8}});
  // A shelf at the wall from (8, 0) to (5, 8).
  test.addMesh(room, "shelf",
               polygonOf({{2, 0, 1}, {2, 8, 1}, {5, 8, 1}, {8, 0, 1}}, test.texture().texture));
  test.addLight(room, {2.1, 1.3, 1.7}, 100);
  const Level& level = test.finished();
  const TruthLight light(level);
  for (double part = 0.0005; part < 1; part += 0.001) {
    const Vec3 p = Vec3{8, 0, 1} + part * Vec3{-3, 8, 0};
    ASSERT_EQ(light.at(facePoint(level, 0, 1, p)).x, 100) << part;
  }
}

TEST(TruthMeshLight, IsNotStoppedByTheFaceItselfHoweverItGrazesIt) {
  LitHall scene;
  const SectorId large = scene.test.addBox("large", {0, 0}, {4000, 4000}, {0, 1000});
  scene.test.addMesh(large, "face",
                     {{{Vec3{1, 2, 3}, {2001, 7, 4}, {11, 2001, 5}}, {}, scene.image}});
  const Level& level = scene.test.finished();
  const SurfacePoint place = facePoint(level, 0, 0, {});
  const auto& corners = level.meshFaces[0].corners;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto pointOf = [&] {
    const double a = unit(random);
    const double b = (1 - a) * unit(random);
    return corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0]);
  };
  for (int i = 0; i < 200; ++i) {
    Level lit = level;
    LightSource light;
    light.sector = large;
    light.position = pointOf() + 2e-6 * place.normal;
    lit.lights = {light};
    ASSERT_GT(levelAt(lit, facePoint(lit, 0, 0, pointOf())), 0) << i;
  }
}

/// A sphere of so many slices and stacks, whose faces are seen from outside.
std::vector<MeshFace> sphereOf(Vec3 center, double radius, int slices, TextureId texture) {
  const double pi = std::acos(-1);
  const auto at = [&](int slice, int stack) {
    const double turn = 2 * pi * (slice % slices) / slices;
    const double tilt = pi * stack / slices;
    return center + radius * Vec3{std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                                  -std::cos(tilt)};
  };
  std::vector<MeshFace> faces;
  for (int stack = 0; stack < slices; ++stack)
    for (int slice = 0; slice < slices; ++slice) {
      const std::vector<Vec3> corners{at(slice, stack), at(slice, stack + 1),
                                      at(slice + 1, stack + 1), at(slice + 1, stack)};
      for (const MeshFace& face : polygonOf(corners, texture))
        if (length(frontOf(face)) > 1e-6) faces.push_back(face);
    }
  return faces;
}

TEST(TruthMeshLight, OfAConvexMeshIsThatOfTheFacesThatSeeTheLight) {
  LitHall scene;
  scene.add(sphereOf({4, 4, 2}, 1, 16, scene.image));
  scene.light({6, 3, 3});
  const Level& level = scene.test.finished();
  const TruthLight light(level);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  int lit = 0;
  int dark = 0;
  for (std::uint32_t i = 0; i < level.meshes[0].faceCount; ++i)
    for (int k = 0; k < 20; ++k) {
      // From the third on on an edge or, of them the first, on a corner.
      const double a = k == 0 ? 0 : unit(random);
      const double b = k < 7 ? 0 : (1 - a) * unit(random);
      const auto& corners = level.meshFaces[i].corners;
      const auto first = static_cast<std::size_t>(k % 3);
      const Vec3 point = (1 - a - b) * corners[first] + a * corners[(first + 1) % 3] +
                         b * corners[(first + 2) % 3];
      const SurfacePoint place = facePoint(level, 0, i, point);
      ASSERT_GT(dot(place.normal, point - Vec3{4, 4, 2}), 0) << "seen from outside";
      const double front = dot(place.normal, level.lights[0].position - point);
      if (std::abs(front) < 1e-5) continue;
      ASSERT_EQ(light.at(place).x, front > 0 ? 100 : 0) << i << ' ' << k;
      ++(front > 0 ? lit : dark);
    }
  EXPECT_GT(lit, 1000);
  EXPECT_GT(dark, 1000);
}

// ---- sectors

constexpr std::uint32_t kTowardsSmallerY = 4;

/// Two rooms along x, in the first a box that reaches 1 m into where the second is, and a light in
/// the second beside it.
struct Straddled : Row {
  Straddled() : Row({{0, 4}, {0, 4}}) {
    test.addMesh(rooms[0], "box", boxOf({3, 1.5, 0}, {5, 2.5, 2}, test.texture().texture));
    test.addLight(rooms[1], {4.5, 0.5, 1}, 100);
  }
};

TEST(TruthMeshLight, ComesFromBothSidesOfAnOpeningThatTheMeshStraddles) {
  Straddled scene;
  const Level& level = scene.test.finished();
  for (const double x : {3.5, 4.0, 4.5})
    EXPECT_EQ(levelAt(level, facePoint(level, 0, kTowardsSmallerY, {x, 1.5, 1})), 100) << x;
}

TEST(TruthMeshLight, DoesNotReachWhatOfAMeshLiesBehindASolidWall) {
  Straddled scene;
  scene.close();
  const Level& level = scene.test.finished();
  for (const double x : {3.5, 4.5})
    EXPECT_EQ(levelAt(level, facePoint(level, 0, kTowardsSmallerY, {x, 1.5, 1})), 0) << x;
}

TEST(TruthMeshShadow, FallsOnBothSidesOfAnOpeningThatTheMeshStraddles) {
  for (const bool isClosed : {false, true}) {
    Straddled scene;
    if (isClosed) scene.close();
    const Level& level = scene.test.finished();
    // The light is 1 m before the box, which ends 2 m before it; these are 3 m before it.
    EXPECT_EQ(levelAt(level, floorPoint(scene.rooms[1], {4.5, 3.5})), isClosed ? 100 : 0)
        << "a mesh behind a wall stops nothing before it";
    EXPECT_EQ(levelAt(level, floorPoint(scene.rooms[1], {7, 3.5})), 100);
    EXPECT_EQ(levelAt(level, floorPoint(scene.rooms[0], {3.9, 3.5})), 0);
  }
}

TEST(TruthMeshShadow, IsNoneOfWhatPokesThroughAWallBesideAnOpening) {
  Row row({{0, 4}, {0, 4}});
  row.leaveHatch();
  const TextureId image = row.test.texture().texture;
  row.test.addMesh(row.rooms[0], "box", boxOf({3, 1, 0}, {5, 3, 0.5}, image));
  row.test.addLight(row.rooms[0], {3.5, 2, 1.9}, 100);
  const Level& level = row.test.finished();
  // Through the hatch at a height of 1.1 m, down to where the box is behind the wall.
  EXPECT_EQ(levelAt(level, floorPoint(row.rooms[1], {4.6875, 2})), 100);
  EXPECT_EQ(levelAt(level, floorPoint(row.rooms[0], {3.5, 2})), 0);
}

TEST(TruthMeshShadow, FallsThroughFlatPortals) {
  Storeys storeys;
  const TextureId image = storeys.test.texture().texture;
  storeys.test.addMesh(storeys.upper[0], "table", tableAt(4, {1, 1}, {2, 3}, image));
  storeys.test.addLight(storeys.upper[0], {1.5, 2, 5}, 100);
  const Level& level = storeys.test.finished();
  // 1 m below the light the table's edge is 0.5 m aside: 2.5 m on the floor, 5 m below.
  EXPECT_EQ(levelAt(level, floorPoint(storeys.lower[0], {3.9, 2})), 0);
  EXPECT_EQ(levelAt(level, floorPoint(storeys.lower[0], {0.1, 2})), 0);
  storeys.test.addLight(storeys.upper[1], {3.5, 2, 5}, 10);
  EXPECT_EQ(levelAt(storeys.test.level(), floorPoint(storeys.lower[0], {3.9, 2})), 10);
}

TEST(TruthMeshShadow, IsNoneOfAMeshOfASectorThatMerelyOverlaps) {
  TestLevel test;
  const SectorId here = test.addBox("here", {0, 0}, {8, 4}, {0, 4});
  const SectorId there = test.addBox("there", {0, 0}, {8, 4}, {0, 4});
  test.addMesh(there, "table", tableAt(1, {3, 1}, {5, 3}, test.texture().texture));
  test.addLight(here, {4, 2, 3}, 100);
  const Level& level = test.finished();
  EXPECT_EQ(levelAt(level, floorPoint(here, {4, 2})), 100) << "stops no light";
  EXPECT_EQ(levelAt(level, facePoint(level, 0, 0, {4, 2, 1})), 0) << "takes none";
  test.addLight(there, {4, 2, 3}, 7);
  EXPECT_EQ(levelAt(test.level(), floorPoint(there, {4, 2})), 0);
  EXPECT_EQ(levelAt(test.level(), facePoint(level, 0, 0, {4, 2, 1})), 7);
}

// ---- in pictures

TEST(TruthMeshLight, ShowsInPicturesWithTheMeshsSectorsOwn) {
  LitHall scene;
  scene.add(boardAcrossX(5, {3, 1}, {5, 3}, scene.image));
  scene.light({1, 4, 2}, 120, 0.25);
  scene.test.sector(scene.hall).light = 0.2;
  scene.test.finished();
  const TruthView view(scene.test.level(), scene.test.textures(), cameraAt(scene.hall, {1, 4, 2}));
  EXPECT_EQ(view.hit(4, 2).kind, SurfaceKind::Mesh);
  EXPECT_NEAR(view.pixel(4, 2, TruthLightMode::Only).exact.x, 60 + 51, 1e-9);
  EXPECT_NEAR(view.pixel(4, 2, TruthLightMode::Both).light.x, 60 / 255.0 + 0.2, 1e-12);
}

}  // namespace
}  // namespace hearth
