#include "truth/truth_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_level.h"

namespace hearth {
namespace {

/// A box of 4 m whose walls wear images of 16 x 16 texels, 1 m a repeat; texel (x, y) is of the
/// colour (x, y, number of the texture).
struct BoxScene {
  TestLevel test;
  SectorId box = test.addBox("box", {0, 0}, {4, 4}, {0, 4});
};

TEST(TruthView, PutsPointsOnTheRowsAndColumnsOfTheProjection) {
  BoxScene scene;
  const Level& level = scene.test.finished();
  Shot camera = cameraAt(scene.box, {1, 2, 2});  // 90 degrees over 8 pixels: 4 pixels per tangent
  const TruthView straight(level, scene.test.textures(), camera);
  const Vec3 ahead = straight.hit(4, 2).point;
  EXPECT_EQ(ahead.x, 4);
  EXPECT_NEAR(ahead.y, 2, 1e-12);
  EXPECT_NEAR(ahead.z, 2, 1e-12);
  // 1 pixel right and 2 up, 3 m deep: 3/4 m to the right (+y), 3/2 m up.
  const Vec3 aside = straight.hit(5, 0).point;
  EXPECT_NEAR(aside.y, 2.75, 1e-12);
  EXPECT_NEAR(aside.z, 3.5, 1e-12);

  camera.pitch = 45;  // the horizon moves down by 4 rows
  const TruthView up(level, scene.test.textures(), camera);
  EXPECT_NEAR(up.hit(4, 6).point.z, 2, 1e-12);
  EXPECT_NEAR(up.hit(4, 4.5).point.z, 2 + 3 * 1.5 / 4, 1e-12);

  camera.pitch = 0;
  camera.angle = 90;  // looks along +y; -x is to the right
  camera.fov = 60;
  const TruthView south(level, scene.test.textures(), camera);
  EXPECT_NEAR(south.hit(8, 2).point.x, 0, 1e-12);
  EXPECT_NEAR(south.hit(8, 2).point.y, 2 + std::sqrt(3), 1e-12);
}

TEST(TruthView, ShowsTheTexelUnderThePixelAtAKnownLight) {
  BoxScene scene;
  scene.test.sector(scene.box).light = 0.25;
  scene.test.addLight(scene.box, {1, 2, 2}, 102, 1.0 / 3);  // 51 levels, 0.2, at 3 m
  Segment& wall = scene.test.wall(scene.box, 1);
  TextureMapping& texture = std::get<Solid>(wall.wall).texture;
  texture.repeat = {2, 4};
  texture.offsetTexels = {-0.5, 3};
  const Level& level = scene.test.finished();
  const TruthView view(level, scene.test.textures(), cameraAt(scene.box, {1, 2, 2}));

  // Texel coordinates at (4, 2, 2): u = 0.5 + 16 * 2 / 2, v = -3 + 16 * 2 / 4.
  const TruthHit hit = view.hit(4, 2);
  EXPECT_NEAR(view.texelAt(hit).x, 16.5, 1e-9);
  EXPECT_NEAR(view.texelAt(hit).y, 5, 1e-9);
  const double down = 2 + 1e-6;
  const auto number = static_cast<std::uint8_t>(texture.texture.index());
  EXPECT_EQ(view.pixel(4, down, TruthLightMode::None).color, (Rgb{0, 5, number}));
  const TruthPixel lit = view.pixel(4, down, TruthLightMode::Both);
  EXPECT_NEAR(lit.exact.y, 5 * 0.45, 1e-5);
  EXPECT_EQ(lit.color.g, 2);
  const TruthPixel light = view.pixel(4, down, TruthLightMode::Only);
  EXPECT_NEAR(light.exact.x, 114.75, 1e-4);
  EXPECT_EQ(light.color, (Rgb{115, 115, 115}));
}

TEST(TruthView, LightNeverExceedsTheTextureAndHalvesRoundUp) {
  BoxScene scene;
  scene.test.sector(scene.box).light = 0.5;
  const Level& dim = scene.test.finished();
  const TruthView half(dim, scene.test.textures(), cameraAt(scene.box, {1, 2, 2}));
  EXPECT_EQ(half.pixel(4, 2, TruthLightMode::Only).color.r, 128);  // 127.5

  scene.test.addLight(scene.box, {2, 2, 2}, 1e6);
  const TruthView bright(scene.test.finished(), scene.test.textures(),
                         cameraAt(scene.box, {1, 2, 2}));
  EXPECT_EQ(bright.pixel(4, 2, TruthLightMode::Only).exact, (Vec3{255, 255, 255}));
}

TEST(TruthView, TexturesRepeatForNegativeCoordinatesToo) {
  BoxScene scene;
  scene.test.sector(scene.box).floor.textureOrigin = {100, 100};
  const TruthView view(scene.test.finished(), scene.test.textures(),
                       cameraAt(scene.box, {1, 2, 2}));
  const TruthHit hit = view.hit(4.1, 6.5);  // the floor, 4 * 2 / 4.5 m ahead
  const Vec2 texel = view.texelAt(hit);
  EXPECT_NEAR(texel.x, 16 * (1 + 8 / 4.5 - 100), 1e-9);
  // floor(16 * -97.222...) = -1556 = 12 - 98 * 16.
  EXPECT_EQ(view.pixel(4.1, 6.5, TruthLightMode::None).color.r, 12);
}

TEST(TruthView, SkiesKeepTheirEdgeRowsAndTheirBrightness) {
  BoxScene scene;
  scene.test.sector(scene.box).ceiling.isSky = true;
  scene.test.sector(scene.box).ceiling.texture->repeat = {1, 0.5};
  Shot camera = cameraAt(scene.box, {0.5, 2, 3.99});
  const Level& level = scene.test.finished();
  camera.angle = 45;
  const TruthView view(level, scene.test.textures(), camera);
  // 45 degrees are an eighth of the image. Row 15 - floor(16 * 0.25 / 0.5) at a tangent of 0.25.
  const TruthHit sky = view.hit(4, 1);
  EXPECT_EQ(sky.kind, SurfaceKind::SkyCeiling);
  EXPECT_NEAR(view.texelAt(sky).x, 2, 1e-9);
  EXPECT_NEAR(view.texelAt(sky).y, 8, 1e-9);
  EXPECT_EQ(view.pixel(4.1, 0.9, TruthLightMode::Both).color.g, 7);
  EXPECT_EQ(view.pixel(4.1, -4, TruthLightMode::Both).color.g, 0);  // beyond the image's upper edge
  EXPECT_EQ(view.pixel(4.1, 1, TruthLightMode::Only).color, (Rgb{255, 255, 255}));
}

TEST(TruthView, IsClearAwayFromEdgesAndTexelBordersOnly) {
  BoxScene scene;
  const Level& level = scene.test.finished();
  const TruthView view(level, scene.test.textures(), cameraAt(scene.box, {1, 2.03, 2.03}));
  // A texel of the wall 3 m ahead covers 1/12 pixel; its middle is 0.00125 m from the eye's axis.
  EXPECT_TRUE(view.isClear(4.0, 2.0, 0.02));
  EXPECT_FALSE(view.isClear(4.0, 2.0, 0.2));
  // The wall's upper edge is 1.97 m up, 3 m away.
  EXPECT_FALSE(view.isClear(4.0, 2 - 4 * 1.97 / 3 + 0.01, 0.02));
}

TEST(TruthView, PictureHoldsThePixelsAtTheirCentres) {
  BoxScene scene;
  scene.test.addLight(scene.box, {2, 1, 3}, 200, 0.1);
  const Level& level = scene.test.finished();
  const TruthView view(level, scene.test.textures(), cameraAt(scene.box, {1, 2, 2}));
  const Image picture = view.picture(TruthLightMode::Only);
  ASSERT_EQ(picture.width(), 8);
  ASSERT_EQ(picture.height(), 4);
  EXPECT_EQ(picture.at(3, 1), view.pixel(3.5, 1.5, TruthLightMode::Only).color);
  EXPECT_NE(picture.at(3, 1), picture.at(4, 2));
}

TEST(TruthView, AnEyeOnABorderSeesNoHole) {
  TestLevel test;
  const SectorId west = test.addBox("west", {0, 0}, {4, 4}, {0, 4});
  const SectorId east = test.addBox("east", {4, 0}, {8, 4}, {0, 4});
  test.link(west, east);
  const Level& level = test.finished();
  for (const Vec3 eye : {Vec3{4, 2, 1}, Vec3{4, 0, 0}, Vec3{4, 4, 4}}) {
    for (int angle = 0; angle < 360; angle += 15) {
      for (const SectorId sector : {west, east}) {
        Shot camera = cameraAt(sector, eye);
        camera.angle = angle;
        TruthView(level, test.textures(), camera).picture(TruthLightMode::None);
      }
    }
  }
}

}  // namespace
}  // namespace hearth
