#include "truth/truth_sprites.h"

#include <gtest/gtest.h>

#include <cmath>

#include "look.h"
#include "support/level_text.h"
#include "test_level.h"
#include "truth/truth_view.h"

namespace hearth {
namespace {

/// A hall of 8 x 8 x 4 m. The eye is 1 m before the middle of its west wall and looks along +x at a
/// sprite of 2 x 2 m and 4 x 4 texels, each of half a metre, 4 m before it.
struct Hall {
  TestLevel test;
  SectorId hall = test.addBox("hall", {0, 0}, {8, 8}, {0, 4});
  TextureMapping image = test.texture(4, 4);
  Vec3 eye{1, 4, 2};

  Sprite& add(Facing facing, double angle = 0, Vec3 position = {5, 4, 1}) {
    Sprite& sprite = test.addSprite(hall, position, facing, {2, 2}, image);
    sprite.angle = angle;
    return sprite;
  }
  Look look(double angle = 0) { return {finished(), cameraAt(hall, eye, angle)}; }
  const TestLevel& finished() {
    test.finished();
    return test;
  }
};

TEST(TruthSprites, ThatFaceTheCameraShowTheirTexelsOnAPlaneOfOneDepth) {
  Hall scene;
  scene.add(Facing::Camera);
  const Look look = scene.look();
  EXPECT_EQ(look.at({5, 3.1, 2.9}).color, texel(0, 0, scene.image));
  EXPECT_EQ(look.at({5, 3.6, 2.9}).color, texel(1, 0, scene.image));
  EXPECT_EQ(look.at({5, 4.9, 1.1}).color, texel(3, 3, scene.image));
  EXPECT_EQ(look.kindAt({5, 3.1, 2.9}), SurfaceKind::CameraSprite);
  for (const Vec3 outside : {Vec3{5, 2.9, 2}, {5, 5.1, 2}, {5, 4, 0.9}, {5, 4, 3.1}})
    EXPECT_FALSE(isSprite(look.kindAt(outside)));

  // Turned by 36.87 degrees it is 3.2 m deep, and still parallel to the picture.
  const double turned = std::atan2(3, 4) * 180 / std::acos(-1);
  const Look aside = Look(scene.test, cameraAt(scene.hall, scene.eye, turned));
  const Vec3 right{-0.6, 0.8, 0};
  EXPECT_EQ(aside.at(Vec3{5, 4, 2.9} + -0.9 * right).color, texel(0, 0, scene.image));
  const TruthHit hit = aside.at(Vec3{5, 4, 1.1} + 0.9 * right).hit;
  EXPECT_EQ(hit.kind, SurfaceKind::CameraSprite);
  EXPECT_NEAR(hit.t, 3.2, 1e-12);
  EXPECT_NEAR(dot(hit.normal, {0.8, 0.6, 0}), -1, 1e-12);
}

TEST(TruthSprites, HitsSayWhichSpriteAndWhereOnItsImage) {
  Hall scene;
  scene.add(Facing::Camera, 0, {6, 6, 1});
  scene.add(Facing::Camera);
  const Look look = scene.look();
  const TruthHit hit = look.at({5, 3.25, 2.5}).hit;
  EXPECT_EQ(hit.sector, scene.hall);
  EXPECT_EQ(hit.segment, std::nullopt);
  EXPECT_EQ(hit.sprite, scene.test.level().sprites[1].surface);
  EXPECT_NEAR(hit.imageMetres.x, 0.25, 1e-12);
  EXPECT_NEAR(hit.imageMetres.y, 0.5, 1e-12);
  const Vec2 place = texelOf(hit, 4, 4);
  EXPECT_NEAR(place.x, 0.5, 1e-12);
  EXPECT_NEAR(place.y, 1, 1e-12);
  const TruthHit other = look.at({6, 6.5, 1.5}).hit;
  EXPECT_EQ(other.sprite, scene.test.level().sprites[0].surface);
  EXPECT_FALSE(isSameSurface(hit, other));
}

TEST(TruthSprites, ThatAreFixedStandAcrossTheirAngleAndAreMirroredFromBehind) {
  Hall front;
  front.add(Facing::Angle, 180);
  EXPECT_EQ(front.look().at({5, 3.1, 2.9}).color, texel(0, 0, front.image));
  Hall back;
  back.add(Facing::Angle, 0);
  EXPECT_EQ(back.look().at({5, 3.1, 2.9}).color, texel(3, 0, back.image));
  Hall edgeOn;
  edgeOn.add(Facing::Angle, 90);
  EXPECT_EQ(edgeOn.look().kindAt({5, 4, 2}), SurfaceKind::Solid);

  Hall oblique;  // its right end is the farther one
  oblique.add(Facing::Angle, 135);
  const Look look = oblique.look();
  const Vec3 right{std::sqrt(0.5), std::sqrt(0.5), 0};
  EXPECT_EQ(look.at(Vec3{5, 4, 2.9} + 0.9 * right).color, texel(3, 0, oblique.image));
  EXPECT_EQ(look.at(Vec3{5, 4, 1.1} + -0.9 * right).color, texel(0, 3, oblique.image));
  EXPECT_EQ(look.kindAt(Vec3{5, 4, 2} + 1.1 * right), SurfaceKind::Solid);
  EXPECT_NEAR(look.at(Vec3{5, 4, 2.9} + 0.9 * right).hit.t, 4 + 0.9 * std::sqrt(0.5), 1e-12);
}

TEST(TruthSprites, ThatLieHaveTheirTopTowardsTheirAngleAndAreSeenFromAboveAndBelow) {
  Hall scene;
  scene.add(Facing::Flat);
  const Look above = scene.look();
  EXPECT_EQ(above.at({5.9, 4.9, 1}).color, texel(3, 0, scene.image));
  EXPECT_EQ(above.at({4.1, 4.9, 1}).color, texel(3, 3, scene.image));
  EXPECT_EQ(above.at({4.1, 3.1, 1}).color, texel(0, 3, scene.image));
  EXPECT_EQ(above.at({5, 4, 1}).hit.normal, (Vec3{0, 0, 1}));
  EXPECT_FALSE(isSprite(above.kindAt({6.1, 4, 1})));
  const Look below(scene.test, cameraAt(scene.hall, {1, 4, 0.5}));
  EXPECT_EQ(below.at({5.9, 4.9, 1}).color, texel(3, 0, scene.image));
  EXPECT_EQ(below.at({5, 4, 1}).hit.normal, (Vec3{0, 0, -1}));

  Hall turned;
  turned.add(Facing::Flat, 90);
  EXPECT_EQ(turned.look().at({5.9, 4.9, 1}).color, texel(0, 0, turned.image));
  EXPECT_EQ(turned.look().at({5.9, 3.1, 1}).color, texel(0, 3, turned.image));
}

/// Images of one texel each.
std::vector<SpriteView> addViews(TestLevel& test, std::size_t count) {
  std::vector<SpriteView> views;
  for (std::size_t k = 0; k < count; ++k) views.push_back({test.texture(1, 1).texture, {2, 2}});
  return views;
}

/// The number of the image that a camera shows that stands at `angle` of a sprite and looks at it.
std::size_t viewShownFrom(double angle, double spriteAngle, std::size_t count) {
  Hall scene;
  Sprite& sprite = scene.add(Facing::Camera, spriteAngle, {4, 4, 1});
  sprite.frames[0] = addViews(scene.test, count);
  const std::uint8_t first = static_cast<std::uint8_t>(sprite.frames[0][0].texture.index());
  const double radians = angle * std::acos(-1) / 180;
  scene.eye = {4 + 3 * std::cos(radians), 4 + 3 * std::sin(radians), 2};
  return static_cast<std::size_t>(scene.look(angle + 180).at({4, 4, 2}).color.b - first);
}

TEST(TruthSprites, ShowTheImageOfTheNearestNthOfATurn) {
  for (std::size_t k = 0; k < 8; ++k) {
    const double middle = 30 + 45.0 * static_cast<double>(k);
    EXPECT_EQ(viewShownFrom(middle, 30, 8), k);
    EXPECT_EQ(viewShownFrom(middle - 22.4, 30, 8), k);
    EXPECT_EQ(viewShownFrom(middle + 22.4, 30, 8), k);
    EXPECT_EQ(viewShownFrom(middle + 22.6, 30, 8), (k + 1) % 8);
  }
  EXPECT_EQ(viewShownFrom(89, 0, 2), 0U);
  EXPECT_EQ(viewShownFrom(91, 0, 2), 1U);
  EXPECT_EQ(viewShownFrom(90, 360, 3), 1U);  // 60 degrees are the border
  EXPECT_EQ(viewShownFrom(59, -360, 3), 0U);
}

TEST(TruthSprites, HaveTheSizeOfTheImageThatShows) {
  Hall scene;
  Sprite& sprite = scene.add(Facing::Camera, 0);
  const TextureMapping behind = scene.test.texture(4, 4);
  sprite.frames[0].push_back({behind.texture, {4, 1}});
  const Look look = scene.look();  // from behind
  EXPECT_EQ(look.at({5, 2.1, 1.9}).color, texel(0, 0, behind));
  EXPECT_EQ(look.at({5, 5.9, 1.1}).color, texel(3, 3, behind));
  EXPECT_EQ(look.kindAt({5, 4, 2.1}), SurfaceKind::Solid);
}

TEST(TruthSprites, AreShiftedAlongTheirOwnRightAndUp) {
  Hall camera;
  camera.add(Facing::Camera).offset = {0.5, 0.25};
  EXPECT_EQ(camera.look().at({5, 3.6, 3.15}).color, texel(0, 0, camera.image));
  Hall fixed;
  fixed.add(Facing::Angle, 0).offset = {0.5, 0.25};  // from behind its right is to the left
  EXPECT_EQ(fixed.look().at({5, 2.6, 3.15}).color, texel(3, 0, fixed.image));
  Hall flat;
  flat.add(Facing::Flat).offset = {0.5, 0.25};
  EXPECT_EQ(flat.look().at({6.15, 5.4, 1}).color, texel(3, 0, flat.image));
}

TEST(TruthSprites, FromFilesAreOneMetreFor64TexelsUnlessTheySay) {
  const LoadedLevel level = test::levelFrom(
      "{'light':1,'sectors':{" + test::sectorText("a", "0,0, 8,0, 8,8, 0,8", 0, 4) +
      "},'things':[{'sprite':'#ff0000','x':5,'y':4,'z':2},"
      "{'sprite':'#00ff00','x':5,'y':6,'z':1,'size':[2,1],'facing':'angle','angle':180}]}");
  const TruthView view(level.level, level.textures, cameraAt(SectorId(0), {1, 4, 2}));
  const double halfTexelPx = 1.0 / 128;
  const auto color = [&](double i, double j) {
    return view.pixel(i, j, TruthLightMode::None).color;
  };
  EXPECT_EQ(color(4 + 0.9 * halfTexelPx, 2 - 1.9 * halfTexelPx), (Rgb{255, 0, 0}));
  EXPECT_EQ(color(4 + 1.1 * halfTexelPx, 2 - 1.9 * halfTexelPx), (Rgb{128, 128, 128}));
  EXPECT_EQ(color(4 + 0.9 * halfTexelPx, 2 - 2.1 * halfTexelPx), (Rgb{128, 128, 128}));
  EXPECT_EQ(color(5.1, 2.9), (Rgb{0, 255, 0}));
  EXPECT_EQ(color(6.9, 2.1), (Rgb{0, 255, 0}));
}

TEST(TruthSprites, ShowWhatIsBehindThroughTheirHoles) {
  Hall scene;
  scene.test.makeHole(scene.image.texture, 0, 0);
  scene.add(Facing::Camera);
  const TextureMapping behind = scene.test.texture(1, 1);
  scene.test.addSprite(scene.hall, {6, 3, 1}, Facing::Camera, {1, 2}, behind);
  const Look look = scene.look();
  EXPECT_EQ(look.at({5, 3.25, 2.75}).color, texel(0, 0, behind));
  EXPECT_EQ(look.kindAt({5, 3.05, 2.9}), SurfaceKind::Solid) << "beside that";
  EXPECT_EQ(look.at({5, 3.25, 2.25}).color, texel(0, 1, scene.image));
}

TEST(TruthSprites, AreNeverWrappedAtTheEdgesOfTheirImages) {
  Hall scene;
  scene.add(Facing::Camera);
  scene.finished();
  TruthHit hit;
  hit.texture = scene.image;
  hit.texture->repeat = {2, 2};
  const Image& image = scene.test.textures()[scene.image.texture.index()];
  hit.imageMetres = {2, 2};
  EXPECT_EQ(spriteTexelOf(hit, image).x, 3);
  EXPECT_EQ(spriteTexelOf(hit, image).y, 3);
}

TEST(TruthSprites, OfTwoAtOneDepthTheLaterShows) {
  Hall scene;
  scene.add(Facing::Camera);
  const TextureMapping later = scene.test.texture(1, 1);
  scene.test.addSprite(scene.hall, {5, 4, 1.5}, Facing::Angle, {2, 1}, later).angle = 180;
  const Look look = scene.look();
  EXPECT_EQ(look.at({5, 4.25, 2.25}).color, texel(0, 0, later));
  EXPECT_EQ(look.at({5, 4.25, 2.75}).color, texel(2, 0, scene.image));
  EXPECT_EQ(look.at({5, 4.25, 1.25}).color, texel(2, 3, scene.image));
}

TEST(TruthSprites, HangOnWallsAndLieOnFloorsAndCeilingsInTheirPlanes) {
  Hall scene;
  scene.add(Facing::Angle, 180, {8, 4, 1});
  scene.add(Facing::Flat, 0, {5, 2, 0});
  scene.add(Facing::Flat, 0, {5, 2, 4});
  const Look look = scene.look();
  EXPECT_EQ(look.at({8, 3.1, 2.9}).color, texel(0, 0, scene.image));
  EXPECT_EQ(look.at({5.9, 2.9, 0}).color, texel(3, 0, scene.image));
  EXPECT_EQ(look.at({5.9, 2.9, 4}).color, texel(3, 0, scene.image));
  EXPECT_EQ(look.kindAt({8, 2.9, 2}), SurfaceKind::Solid);
}

TEST(TruthSprites, ReachIntoAWallUnseen) {
  Hall scene;
  scene.add(Facing::Angle, 225, {8, 4, 1});  // its left end is in the room
  const Look look = scene.look();
  const Vec3 left{-std::sqrt(0.5), std::sqrt(0.5), 0};
  int shown = 0;
  for (int i = -9; i <= 9; ++i)
    if (isSprite(look.kindAt(Vec3{8, 4, 2} + 0.1 * i * left))) ++shown;
  EXPECT_EQ(shown, 10);  // the half in the room, and the line at which it meets the wall
}

TEST(TruthSprites, AreHiddenByPillarsAndSlopesBeforeThem) {
  Hall scene;
  scene.test.addLoop(scene.hall, {{3, 3}, {3, 3.9}, {3.5, 3.9}, {3.5, 3}});
  scene.add(Facing::Camera);
  const Look look = scene.look();
  EXPECT_EQ(look.kindAt({5, 3.5, 2}), SurfaceKind::Solid);
  EXPECT_EQ(look.kindAt({5, 4.5, 2}), SurfaceKind::CameraSprite);

  Hall sloped;  // half a metre higher each metre towards +x
  Slope slope;
  slope.gradient = {0.5, 0};
  slope.sidewall = sloped.test.texture();
  sloped.test.sector(sloped.hall).ceiling.z = 6;
  sloped.test.sector(sloped.hall).floorSlope = slope;
  sloped.add(Facing::Camera, 0, {5, 4, 2});
  const Look up = sloped.look();
  EXPECT_EQ(up.kindAt({5, 4, 2.4}), SurfaceKind::SlopeFloor);
  EXPECT_EQ(up.kindAt({5, 4, 2.6}), SurfaceKind::CameraSprite);
}

// ---- light

/// The light of the sprite before the hall's eye, in levels of red.
double levelShown(Hall& scene) {
  return scene.look().at({5, 4.3, 2.2}, TruthLightMode::Only).exact.x;
}

TEST(TruthSprites, TakeTheLightOfThePointAtHalfTheirHeight) {
  Hall scene;
  scene.add(Facing::Camera);
  LightSource& light = scene.test.addLight(scene.hall, {5, 1, 2}, 200, 0.25);  // 3 m from (5, 4, 2)
  light.color[1] = 51;
  scene.test.sector(scene.hall).light = 0.2;
  const Look look = scene.look();
  const TruthPixel pixel = look.at({5, 3.1, 2.9}, TruthLightMode::Only);
  // 200 / 1.75 = 114.28.. and 22.85.. levels are stored as 114 and 23.
  EXPECT_NEAR(pixel.exact.x, 114 + 51, 1e-9);
  EXPECT_NEAR(pixel.exact.y, 23 + 51, 1e-9);
  EXPECT_EQ(look.at({5, 4.9, 1.1}, TruthLightMode::Only).exact, pixel.exact);
  EXPECT_NEAR(look.at({5, 4.9, 1.1}, TruthLightMode::Both).exact.x, 3 * (114 + 51) / 255.0, 1e-9);
}

TEST(TruthSprites, TakeLightFromBehindAndWithoutACosine) {
  Hall scene;
  scene.add(Facing::Angle, 180);
  scene.test.addLight(scene.hall, {7.5, 4, 2}, 100);
  Level level = scene.finished().level();
  level.bake.lambert = true;
  const TruthView view(level, scene.test.textures(), cameraAt(scene.hall, scene.eye));
  EXPECT_EQ(view.pixel(4.1, 2.1, TruthLightMode::Only).exact.x, 100);
}

TEST(TruthSprites, ThatLieTakeTheLightWhereTheyLieAndCastNoShadows) {
  Hall scene;
  scene.add(Facing::Flat, 0, {5, 4, 0});
  scene.add(Facing::Flat, 0, {5, 4, 1});
  scene.test.addLight(scene.hall, {5, 4, 3}, 100, 1);  // 3 m above the lower one
  const Look look = scene.look();
  EXPECT_EQ(look.at({4.1, 4, 0}, TruthLightMode::Only).exact.x, 25);
  EXPECT_NEAR(look.at({5, 2.7, 0}, TruthLightMode::Only).exact.x, 100 / (1 + std::hypot(3, 1.3)),
              1e-9);
}

TEST(TruthSprites, AreLitWhereTheirPointIsMovedIntoTheAir) {
  Hall scene;
  scene.test.addSprite(scene.hall, {5, 4, 1}, Facing::Camera, {2, 8}, scene.image);
  scene.test.addLight(scene.hall, {5, 1, 4}, 100, 1);  // 3 m from (5, 4, 4): half the height is 5 m
  EXPECT_EQ(levelShown(scene), 25);
}

TEST(TruthSprites, AreDarkWhereNoStraightLineLeadsFromTheLight) {
  Hall scene;
  scene.test.addLoop(scene.hall, {{4, 6}, {4, 6.5}, {6, 6.5}, {6, 6}});
  scene.add(Facing::Camera);
  scene.test.addLight(scene.hall, {5, 7, 2}, 100);  // behind the pillar
  scene.test.addLight(scene.hall, {2, 7, 2}, 50);
  EXPECT_EQ(levelShown(scene), 50);
}

TEST(TruthSprites, SeeThePartOfABallThatNothingHides) {
  Hall scene;
  scene.test.addLoop(scene.hall, {{5, 6}, {5, 6.5}, {6.5, 6.5}, {6.5, 6}});
  scene.add(Facing::Camera);
  scene.test.addLight(scene.hall, {5, 7.2, 2}, 200).radius = 0.5;
  // The pillar's edge is in the line of the centre: of a ball whose centre sees no more than it
  // half is seen.
  EXPECT_NEAR(levelShown(scene), 100, 12);
}

TEST(TruthSprites, ThatAreBrightShowTheirImageAsItIs) {
  Hall scene;
  scene.add(Facing::Camera).isBright = true;
  scene.test.addLight(scene.hall, {5, 1, 2}, 10);
  const Look look = scene.look();
  EXPECT_EQ(look.at({5, 3.6, 2.9}, TruthLightMode::Only).color, (Rgb{255, 255, 255}));
  EXPECT_EQ(look.at({5, 3.6, 2.9}, TruthLightMode::Both).color, texel(1, 0, scene.image));
}

TEST(TruthView, IsNotClearAtTheEdgesAndTexelsOfSprites) {
  Hall scene;
  scene.add(Facing::Camera);
  scene.add(Facing::Camera, 0, {5, 5.2, 1});  // texels of the same colours, one number apart
  const TruthView view(scene.finished().level(), scene.test.textures(),
                       cameraAt(scene.hall, scene.eye));
  EXPECT_TRUE(view.isClear(3.25, 1.25, 0.02));
  EXPECT_FALSE(view.isClear(3.01, 1.25, 0.02)) << "beside it is the wall";
  EXPECT_FALSE(view.isClear(3.49, 1.25, 0.02)) << "the next texel";
  EXPECT_FALSE(view.isClear(4.21, 1.25, 0.02)) << "the other sprite";
}

}  // namespace
}  // namespace hearth
