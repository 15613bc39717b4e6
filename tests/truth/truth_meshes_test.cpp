#include "truth/truth_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "adjoining_rooms.h"
#include "look.h"
#include "mesh_shapes.h"
#include "truth/truth_view.h"

namespace hearth {
namespace {

/// A hall of 8 x 8 x 4 m. The eye is 1 m before the middle of its west wall and looks along +x.
struct Hall {
  TestLevel test;
  SectorId hall = test.addBox("hall", {0, 0}, {8, 8}, {0, 4});
  TextureMapping image = test.texture(4, 4);
  Vec3 eye{1, 4, 2};

  Mesh& add(const std::vector<MeshFace>& faces) { return test.addMesh(hall, "mesh", faces); }
  /// 2 x 2 m, before the eye, which is at the height of its middle.
  std::vector<MeshFace> board(double x = 5) const { return board(x, image); }
  std::vector<MeshFace> board(double x, const TextureMapping& wears) const {
    return boardAcrossX(x, {3, 1}, {5, 3}, wears.texture);
  }
  Look look(double angle = 0) {
    test.finished();
    return {test, cameraAt(hall, eye, angle)};
  }
};

TEST(TruthMeshes, ShowTheFrontsOfTheirFacesAlone) {
  Hall front;
  front.add(front.board());
  const TruthHit hit = front.look().at({5, 4.3, 2.2}).hit;
  EXPECT_EQ(hit.kind, SurfaceKind::Mesh);
  EXPECT_EQ(hit.normal, (Vec3{-1, 0, 0}));
  Hall back;
  back.add(turnedOver(back.board()));
  EXPECT_EQ(back.look().kindAt({5, 4.3, 2.2}), SurfaceKind::Solid);
  Hall behind;
  behind.add(behind.board(2));
  behind.eye = {4, 4, 2};
  EXPECT_EQ(behind.look(180).kindAt({2, 4.3, 2.2}), SurfaceKind::Solid);
  EXPECT_EQ(Look(behind.test, cameraAt(behind.hall, {1, 4, 2})).kindAt({2, 4.3, 2.2}),
            SurfaceKind::Mesh);
}

TEST(TruthMeshes, ThatAreTwoSidedShowTheirBacksToo) {
  Hall scene;
  scene.add(turnedOver(scene.board())).isTwoSided = true;
  const TruthPixel pixel = scene.look().at({5, 3.1, 2.9});
  EXPECT_EQ(pixel.hit.kind, SurfaceKind::Mesh);
  EXPECT_EQ(pixel.hit.normal, (Vec3{-1, 0, 0})) << "towards the eye";
  EXPECT_EQ(pixel.color, texel(0, 0, scene.image));
}

TEST(TruthMeshes, HitsSayWhichMeshAndFaceAndWhereOnItsImage) {
  Hall scene;
  scene.add(boardAcrossX(6, {6, 1}, {7, 2}, scene.image.texture));
  scene.add(scene.board());
  const Look look = scene.look();
  const TruthHit lower = look.at({5, 4.5, 1.25}).hit;  // right of the diagonal
  const TruthHit upper = look.at({5, 3.5, 2.75}).hit;
  EXPECT_EQ(lower.sector, scene.hall);
  EXPECT_EQ(lower.segment, std::nullopt);
  EXPECT_EQ(lower.sprite, std::nullopt);
  EXPECT_EQ(lower.mesh, scene.test.level().meshes[1].surface);
  EXPECT_EQ(lower.face, 2U);
  EXPECT_EQ(upper.face, 3U);
  EXPECT_FALSE(isSameSurface(lower, upper));
  EXPECT_TRUE(isSameSurface(upper, look.at({5, 3.25, 2.75}).hit));
  EXPECT_NEAR(lower.t, 4, 1e-12);
  EXPECT_NEAR(length(lower.point - Vec3{5, 4.5, 1.25}), 0, 1e-12);
  EXPECT_NEAR(length(lower.imageMetres - Vec2{0.75, 0.875}), 0, 1e-12);
  EXPECT_NEAR(length(texelOf(lower, 4, 4) - Vec2{3, 3.5}), 0, 1e-12);
  const TruthHit other = look.at({6, 6.5, 1.25}).hit;
  EXPECT_EQ(other.mesh, scene.test.level().meshes[0].surface);
  EXPECT_FALSE(isSameSurface(lower, other));
}

TEST(TruthMeshes, ShowTheTexelsThatTheirCornersSay) {
  Hall scene;
  scene.add(scene.board());
  const Look look = scene.look();
  EXPECT_EQ(look.at({5, 3.1, 2.9}).color, texel(0, 0, scene.image));
  EXPECT_EQ(look.at({5, 3.6, 2.9}).color, texel(1, 0, scene.image));
  EXPECT_EQ(look.at({5, 4.9, 1.1}).color, texel(3, 3, scene.image));
  EXPECT_EQ(look.at({5, 3.1, 1.1}).color, texel(0, 3, scene.image));

  Hall repeated;  // from -1.5 to 0.5 to the right, and from 0.25 to 2.25 down
  std::vector<MeshFace> faces = repeated.board();
  for (MeshFace& face : faces)
    for (Vec2& p : face.image) p = Vec2{-1.5, 0.25} + 2 * p;
  repeated.add(faces);
  const Look wrapped = repeated.look();
  EXPECT_EQ(wrapped.at({5, 3.05, 2.95}).color, texel(2, 1, repeated.image));
  EXPECT_EQ(wrapped.at({5, 4.95, 1.05}).color, texel(1, 0, repeated.image));
  EXPECT_EQ(wrapped.at({5, 4.05, 2.2}).color, texel(2, 0, repeated.image));
}

TEST(TruthMeshes, ShowTexelsInPerspectiveOnFacesThatRecede) {
  Hall scene;  // a floor of its own, 1 m high: its image's top is far away
  scene.add(polygonOf({{2, 3, 1}, {2, 5, 1}, {6, 5, 1}, {6, 3, 1}}, scene.image.texture));
  const Look look = scene.look();
  const TruthHit hit = look.at({5, 4.5, 1}).hit;
  EXPECT_NEAR(hit.t, 4, 1e-14);
  EXPECT_NEAR(hit.imageMetres.x, 0.75, 1e-14);
  EXPECT_NEAR(hit.imageMetres.y, 0.25, 1e-14);
  EXPECT_EQ(hit.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(look.at({5.1, 4.4, 1}).color, texel(2, 0, scene.image));
}

TEST(TruthMeshes, HaveTheColourOfTheTextureOfEachFace) {
  Hall scene;
  const TextureMapping other = scene.test.texture(1, 1);
  std::vector<MeshFace> faces = scene.board();
  faces[1].texture = other.texture;
  scene.add(faces);
  const Look look = scene.look();
  EXPECT_EQ(look.at({5, 4.6, 1.2}).color, texel(3, 3, scene.image));
  EXPECT_EQ(look.at({5, 3.4, 2.8}).color, texel(0, 0, other));
}

TEST(TruthMeshes, ShowTheNearestOfTheirFaces) {
  for (const bool nearerFirst : {false, true}) {
    Hall scene;
    const TextureMapping nearer = scene.test.texture(1, 1);
    const std::vector<MeshFace> near = scene.board(4, nearer);
    const std::vector<MeshFace> far = scene.board(5);
    scene.add(nearerFirst ? joined(near, far) : joined(far, near));
    EXPECT_EQ(scene.look().at({5, 4.5, 2.5}).color, texel(0, 0, nearer));
  }
}

TEST(TruthMeshes, OfTwoAtOneDepthTheLaterShows) {
  Hall scene;
  scene.add(scene.board());
  const TextureMapping later = scene.test.texture(1, 1);
  scene.add(boardAcrossX(5, {3, 2}, {5, 3}, later.texture));
  const Look look = scene.look();
  EXPECT_EQ(look.at({5, 4.25, 2.25}).color, texel(0, 0, later));
  EXPECT_EQ(look.at({5, 4.25, 1.25}).color, texel(2, 3, scene.image));
}

TEST(TruthMeshes, IncludeTheirEdgesAndCorners) {
  Hall scene;
  scene.add(scene.board());
  const TruthMeshes meshes(scene.test.finished());
  const auto isMet = [&](double y, double z) {
    const Vec3 direction = 0.25 * (Vec3{5, y, z} - scene.eye);
    return meshes.nearest(scene.eye, direction, {scene.hall, 0, 7}).has_value();
  };
  for (const double y : {3.0, 4.0, 5.0})
    for (const double z : {1.0, 2.0, 3.0}) EXPECT_TRUE(isMet(y, z)) << y << ' ' << z;
  EXPECT_FALSE(isMet(std::nextafter(3, 0), 2));
  EXPECT_FALSE(isMet(4, 3 + 1e-15));
}

TEST(TruthMeshes, AreMetInsideTheStretchOfAirAndAtItsEnds) {
  Hall scene;
  scene.add(scene.board());
  const TruthMeshes meshes(scene.test.finished());
  const auto isMet = [&](double tEnter, double tLeave) {
    return meshes.nearest(scene.eye, {1, 0, 0}, {scene.hall, tEnter, tLeave}).has_value();
  };
  EXPECT_TRUE(isMet(0, 4));
  EXPECT_TRUE(isMet(4, 7));
  EXPECT_TRUE(isMet(0, 4 - 1e-9)) << "by rounding";
  EXPECT_FALSE(isMet(0, 4 - 1e-5));
  EXPECT_FALSE(isMet(4 + 1e-5, 7));
}

TEST(TruthMeshes, SeenEdgeOnShowNothing) {
  Hall scene;
  scene.add(polygonOf({{3, 4, 1}, {5, 4, 1}, {5, 4, 3}, {3, 4, 3}}, scene.image.texture))
      .isTwoSided = true;
  scene.add(polygonOf({{3, 3, 2}, {5, 3, 2}, {5, 5, 2}, {3, 5, 2}}, scene.image.texture))
      .isTwoSided = true;
  const Look look = scene.look();
  EXPECT_EQ(look.kindAt({4, 4, 2.5}), SurfaceKind::Solid);
  EXPECT_EQ(look.kindAt({4, 4.5, 2}), SurfaceKind::Solid);
}

// ---- with sprites, the level and the eye

TEST(TruthMeshes, HideAndAreHiddenBySprites) {
  for (const double x : {4.0, 6.0}) {
    Hall scene;
    scene.add(scene.board());
    const TextureMapping onSprite = scene.test.texture(1, 1);
    scene.test.addSprite(scene.hall, {x, 4, 1}, Facing::Camera, {2, 2}, onSprite);
    EXPECT_EQ(scene.look().kindAt({5, 4.5, 2.5}),
              x < 5 ? SurfaceKind::CameraSprite : SurfaceKind::Mesh);
  }
}

TEST(TruthMeshes, AreSeenThroughTheHolesOfSprites) {
  Hall scene;
  scene.add(scene.board());
  const TextureMapping onSprite = scene.test.texture(2, 2);
  scene.test.makeHole(onSprite.texture, 1, 0);
  scene.test.addSprite(scene.hall, {4, 4, 1}, Facing::Camera, {2, 2}, onSprite);
  const Look look = scene.look();
  EXPECT_EQ(look.kindAt({4, 4.5, 2.5}), SurfaceKind::Mesh);
  EXPECT_EQ(look.kindAt({4, 3.5, 2.5}), SurfaceKind::CameraSprite);
}

TEST(TruthMeshes, OfAMeshAndASpriteAtOneDepthTheLaterShows) {
  Hall spriteLater;
  spriteLater.add(spriteLater.board());
  spriteLater.test.addSprite(spriteLater.hall, {5, 4, 1}, Facing::Camera, {2, 2},
                             spriteLater.image);
  EXPECT_EQ(spriteLater.look().kindAt({5, 4.5, 2.5}), SurfaceKind::CameraSprite);
  Hall meshLater;
  meshLater.test.addSprite(meshLater.hall, {5, 4, 1}, Facing::Camera, {2, 2}, meshLater.image);
  meshLater.add(meshLater.board());
  EXPECT_EQ(meshLater.look().kindAt({5, 4.5, 2.5}), SurfaceKind::Mesh);
}

TEST(TruthMeshes, HideAndAreHiddenByMaskedMiddles) {
  Row row({{0, 4}, {0, 4}});
  TextureMapping fence = row.test.texture(4, 4);
  fence.repeat = {4, 4};
  row.test.makeHole(fence.texture, 1, 1);  // y from 1 to 2, z from 2 to 3
  std::get<Portal>(row.test.wall(row.rooms[0], 1).wall).maskedMiddle = fence;
  const TextureMapping image = row.test.texture();
  row.test.addMesh(row.rooms[1], "behind", boardAcrossX(5, {0, 0}, {4, 4}, image.texture));
  row.test.addMesh(row.rooms[0], "before", boardAcrossX(3, {3, 0}, {4, 4}, image.texture));
  row.test.finished();
  const Look look(row.test, cameraAt(row.rooms[0], {1, 2, 2}));
  EXPECT_EQ(look.kindAt({4, 1.5, 2.5}), SurfaceKind::Mesh);
  EXPECT_EQ(look.kindAt({4, 2.5, 2.5}), SurfaceKind::MaskedMiddle);
  EXPECT_EQ(look.kindAt({3, 3.5, 2.5}), SurfaceKind::Mesh);
}

TEST(TruthMeshes, ReachIntoWallsAndFloorsUnseen) {
  Hall scene;
  scene.add(boxOf({7, 3, -1}, {9, 5, 1}, scene.image.texture));
  scene.eye = {1, 4, 3};
  const Look look = scene.look();
  EXPECT_EQ(look.kindAt({7, 4.5, 0.5}), SurfaceKind::Mesh);
  EXPECT_EQ(look.kindAt({7.5, 4.5, 1}), SurfaceKind::Mesh) << "its top";
  EXPECT_EQ(look.kindAt({6.9, 4.5, 0}), SurfaceKind::Floor);
  EXPECT_EQ(look.kindAt({7, 4.5, -0.1}), SurfaceKind::Floor) << "the floor before what is below it";
  EXPECT_EQ(look.kindAt({8, 4.5, 1.1}), SurfaceKind::Solid);
}

TEST(TruthMeshes, InThePlaneOfAWallOrFlatHideIt) {
  Hall scene;
  scene.add(joined(boardAcrossX(8, {3, 1}, {5, 3}, scene.image.texture),
                   polygonOf({{4, 1, 0}, {4, 3, 0}, {6, 3, 0}, {6, 1, 0}}, scene.image.texture)));
  scene.add(
      turnedOver(polygonOf({{4, 1, 4}, {4, 3, 4}, {6, 3, 4}, {6, 1, 4}}, scene.image.texture)));
  const Look look = scene.look();
  EXPECT_EQ(look.at({8, 3.1, 2.9}).color, texel(0, 0, scene.image));
  EXPECT_EQ(look.at({5.9, 2.9, 0}).color, texel(3, 0, scene.image));
  EXPECT_EQ(look.at({5.9, 2.9, 4}).color, texel(3, 0, scene.image));
  EXPECT_EQ(look.kindAt({8, 2.9, 2}), SurfaceKind::Solid);
  EXPECT_EQ(look.kindAt({5.9, 3.1, 0}), SurfaceKind::Floor);
}

TEST(TruthMeshes, ShowAnEyeInThemOnlyWhatIsTwoSided) {
  for (const bool isTwoSided : {false, true}) {
    Hall scene;
    scene.add(boxOf({0.5, 3, 1}, {3, 5, 3}, scene.image.texture)).isTwoSided = isTwoSided;
    scene.test.finished();
    for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
      const TruthHit hit = TruthView(scene.test.level(), scene.test.textures(),
                                     cameraAt(scene.hall, scene.eye, angle))
                               .hit(4.1, 2.1);
      EXPECT_EQ(hit.kind, isTwoSided ? SurfaceKind::Mesh : SurfaceKind::Solid) << angle;
      EXPECT_LT(dot(hit.normal, hit.point - scene.eye), 0);
    }
  }
}

TEST(TruthView, IsNotClearAtTheEdgesAndTexelsOfMeshes) {
  Hall scene;
  const TextureId plain = scene.test.texture(1, 1).texture;
  scene.add(joined(scene.board(), boardAcrossX(5, {5, 1}, {7, 3}, plain)));
  scene.test.finished();
  const TruthView view(scene.test.level(), scene.test.textures(), cameraAt(scene.hall, scene.eye));
  EXPECT_TRUE(view.isClear(3.25, 1.25, 0.02));
  EXPECT_FALSE(view.isClear(3.01, 1.25, 0.02)) << "beside it is the wall";
  EXPECT_FALSE(view.isClear(3.49, 1.25, 0.02)) << "the next texel";
  EXPECT_TRUE(view.isClear(5.9, 2.5, 0.02));
  EXPECT_FALSE(view.isClear(6, 2.01, 0.02)) << "another face of one texel";
}

}  // namespace
}  // namespace hearth
