#include <gtest/gtest.h>

#include "adjoining_rooms.h"
#include "mesh_shapes.h"
#include "truth/truth_view.h"

namespace hearth {
namespace {

/// Whether the camera at the eye, which looks along `angle`, sees a mesh straight ahead.
bool seesMesh(const TestLevel& test, SectorId sector, Vec3 eye, double angle) {
  const Shot camera = cameraAt(sector, eye, angle);
  return TruthView(test.level(), test.textures(), camera).hit(4, 2).kind == SurfaceKind::Mesh;
}

/// Two rooms along x, in the first a box that reaches 1 m into where the second is.
struct Straddled : Row {
  Straddled() : Row({{0, 4}, {0, 4}}) {
    test.addMesh(rooms[0], "box", boxOf({3, 1.5, 0}, {5, 2.5, 2}, test.texture().texture));
  }
};

TEST(TruthMeshes, ShowOnBothSidesOfAnOpeningThatTheyStraddle) {
  Straddled scene;
  scene.test.finished();
  for (const double x : {3.5, 4.5}) {
    EXPECT_TRUE(seesMesh(scene.test, scene.rooms[x > 4], {x, 0.5, 1}, 90));
    EXPECT_TRUE(seesMesh(scene.test, scene.rooms[x > 4], {x, 3.5, 1}, 270));
  }
  EXPECT_TRUE(seesMesh(scene.test, scene.rooms[1], {7, 2, 1}, 180));
}

TEST(TruthMeshes, DoNotShowBehindASolidWallThatTheyPokeThrough) {
  Straddled scene;
  scene.close();
  scene.test.finished();
  EXPECT_TRUE(seesMesh(scene.test, scene.rooms[0], {3.5, 0.5, 1}, 90));
  EXPECT_FALSE(seesMesh(scene.test, scene.rooms[1], {4.5, 0.5, 1}, 90));
  EXPECT_FALSE(seesMesh(scene.test, scene.rooms[1], {7, 2, 1}, 180));
}

TEST(TruthMeshes, AreSeenThroughStacksAndFlatPortals) {
  Row row({{0, 4}, {0, 4}});
  row.leaveHatch();
  const TextureId image = row.test.texture().texture;
  row.test.addMesh(row.rooms[1], "board", boardAcrossX(6, {1, 0}, {3, 4}, image));
  row.test.finished();
  EXPECT_TRUE(seesMesh(row.test, row.rooms[0], {2, 2, 1.5}, 0));
  EXPECT_FALSE(seesMesh(row.test, row.rooms[0], {2, 2, 0.5}, 0));
  EXPECT_FALSE(seesMesh(row.test, row.rooms[0], {2, 2, 2.5}, 0));

  Storeys storeys;
  const TextureId column = storeys.test.texture().texture;
  storeys.test.addMesh(storeys.lower[0], "column", boxOf({1, 1, 0}, {2, 3, 5}, column));
  storeys.test.addMesh(storeys.lower[0], "block", boxOf({1, 3.5, 0}, {2, 4, 3}, column));
  const TruthView below(storeys.test.finished(), storeys.test.textures(),
                        cameraAt(storeys.lower[0], {2.9, 2, 2}, 180));
  EXPECT_EQ(below.hit(4, 2 - 4 * 2.5 / 0.9).mesh, storeys.test.level().meshes[0].surface);
  EXPECT_EQ(below.hit(4, 2 - 4 * 2.5 / 0.9).sector, storeys.lower[0]);
  EXPECT_EQ(below.hit(4, 2 - 4 * 3.5 / 0.9).kind, SurfaceKind::Ceiling) << "over it";
  EXPECT_TRUE(seesMesh(storeys.test, storeys.upper[0], {2.9, 2, 4}, 180));
  const TruthView above(storeys.test.level(), storeys.test.textures(),
                        cameraAt(storeys.upper[0], {2.9, 3.75, 4}, 180));
  EXPECT_EQ(above.hit(4, 2).kind, SurfaceKind::Solid);
  EXPECT_EQ(above.hit(4, 2 + 4 * 1 / 1.4).mesh, storeys.test.level().meshes[1].surface)
      << "its top, in the portal's plane";
}

TEST(TruthMeshes, InAnotherSectorAtThePlaceDoNotShow) {
  TestLevel test;
  const SectorId here = test.addBox("here", {0, 0}, {8, 4}, {0, 4});
  const SectorId there = test.addBox("there", {0, 0}, {8, 4}, {0, 4});
  const TextureId image = test.texture().texture;
  test.addMesh(there, "board", boardAcrossX(5, {1, 0}, {3, 4}, image));
  test.finished();
  EXPECT_FALSE(seesMesh(test, here, {1, 2, 1}, 0));
  EXPECT_TRUE(seesMesh(test, there, {1, 2, 1}, 0));
}

TEST(TruthMeshes, TakeTheLightOfTheirOwnSectorAndThatOfLights) {
  Straddled scene;
  scene.test.sector(scene.rooms[0]).light = 0.2;
  scene.test.sector(scene.rooms[1]).light = 0.6;
  scene.test.addLight(scene.rooms[1], {4.5, 0.5, 1}, 30);
  scene.test.finished();
  const TruthView view(scene.test.level(), scene.test.textures(),
                       cameraAt(scene.rooms[1], {4.5, 0.5, 1}, 90));
  EXPECT_EQ(view.hit(4, 2).sector, scene.rooms[0]);
  EXPECT_NEAR(view.pixel(4, 2, TruthLightMode::Only).exact.x, 51 + 30, 1e-9);
  const Vec3 color = view.pixel(4, 2, TruthLightMode::None).exact;
  EXPECT_NEAR(view.pixel(4, 2, TruthLightMode::Both).exact.x, (0.2 + 30 / 255.0) * color.x, 1e-9);

  Straddled bright;
  bright.test.sector(bright.rooms[0]).light = 3;
  bright.test.finished();
  const TruthView full(bright.test.level(), bright.test.textures(),
                       cameraAt(bright.rooms[1], {4.5, 0.5, 1}, 90));
  EXPECT_EQ(full.pixel(4, 2, TruthLightMode::Only).color, (Rgb{255, 255, 255}));
}

}  // namespace
}  // namespace hearth
