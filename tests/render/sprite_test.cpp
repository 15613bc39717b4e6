// What shows of sprites, and before and behind them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "level/sprite_sectors.h"
#include "light/rebake.h"
#include "light/saved_bake.h"
#include "render/renderer.h"
#include "support/level_text.h"
#include "things_in_halls.h"

namespace hearth {
namespace {

using test::count;
using test::drawn;
using test::hall;
using test::halves;
using test::kGreen;
using test::kRed;
using test::kSize;
using test::kWall;
using test::levelWith;
using test::lookingEast;
using test::sectorText;

TEST(Sprites, standBeforeTheCameraAtTheDepthOfTheirPosition) {
  // 4 m deep a metre is 8 pixels. The sprite's lower edge is 2 m below the eye.
  const Image picture =
      drawn(levelWith("{'sprite':'#c80000','x':4.5,'y':0,'size':[1,1.5]}", hall()), lookingEast());
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const bool covered = column >= 28 && column < 36 && row >= 36 && row < 48;
      ASSERT_EQ(picture.at(column, row) == kRed, covered) << column << ' ' << row;
    }
}

TEST(Sprites, areShiftedToTheRightAndUp) {
  const Image picture = drawn(
      levelWith("{'sprite':'#c80000','x':4.5,'y':0,'size':[1,1],'offset':[0.5,0.25]}", hall()),
      lookingEast());
  EXPECT_EQ(picture.at(32, 38), kRed);
  EXPECT_EQ(picture.at(39, 45), kRed);
  EXPECT_EQ(picture.at(31, 40), kWall) << "left of it";
  EXPECT_EQ(picture.at(35, 46), kWall) << "below it";
}

TEST(Sprites, equalAMaskedMiddleTextureWhereTheyHangInAnOpening) {
  const LoadedLevel hung =
      test::levelFrom(fmt::format("{{'light':1,'sectors':{{{}}}}}",
                                  halves(",'middle':{'name':'#c80000','scale':[8,1.5],'zref':3}")));
  const LoadedLevel stands = levelWith(
      "{'sprite':'#c80000','x':4,'y':0,'z':1.5,'sector':'west','size':[8,1.5],'facing':'angle',"
      "'angle':180}",
      halves());
  for (const double angle : {0.0, 20.0, -50.0})
    for (const double x : {0.5, 2.0, 3.9}) {
      Camera camera = lookingEast(x);
      camera.angle = angle;
      EXPECT_EQ(drawn(stands, camera), drawn(hung, camera)) << angle << ' ' << x;
    }
}

TEST(Sprites, showOnceWhereAnOpeningDividesThem) {
  for (const std::string_view thing :
       {"{'sprite':'#c80000','x':4,'y':0.5,'size':[3,1]}",
        "{'sprite':'#c80000','x':3.5,'y':0.5,'size':[3,1],'facing':'angle','angle':110}",
        "{'sprite':'#c80000','x':4.5,'y':-1,'size':[2,3],'facing':'flat','angle':30}",
        "{'sprite':'#c80000','x':4,'y':1,'z':4,'sector':'west','size':[2,3],'facing':'flat'}"}) {
    std::string whole(thing);
    if (const auto named = whole.find(",'sector':'west'"); named != std::string::npos)
      whole.erase(named, 16);
    std::string divided(thing);
    if (divided.find("'sector'") == std::string::npos &&
        divided.find("'x':4,") != std::string::npos)
      divided.insert(1, "'sector':'west',");
    for (const double angle : {0.0, 30.0, -30.0}) {
      Camera camera = lookingEast();
      camera.angle = angle;
      const Image picture = drawn(levelWith(divided, halves()), camera);
      EXPECT_EQ(picture, drawn(levelWith(whole, hall()), camera)) << thing << ' ' << angle;
    }
  }
}

TEST(Sprites, areHiddenByWhatIsNearerAndByNothingElse) {
  const std::string far = "{'sprite':'#c80000','x':6,'y':0,'size':[1,1]}";
  const std::string near = "{'sprite':'#00c800','x':3,'y':0,'size':[1,1]}";
  for (const std::string& both : {near + "," + far, far + "," + near}) {
    const Image picture = drawn(levelWith(both, halves()), lookingEast());
    EXPECT_EQ(picture.at(32, 50), kGreen);
    EXPECT_EQ(count(picture, kGreen), 12 * 13)
        << "12.8 pixels each way, those with their centres in";
    EXPECT_EQ(picture.at(32, 42), kRed);
  }
}

TEST(Sprites, ofOnePlaceShowTheLater) {
  const Image picture = drawn(levelWith("{'sprite':'#00c800','x':4.5,'y':0,'size':[1,1]},"
                                        "{'sprite':'#c80000','x':4.5,'y':0,'size':[1,1]}",
                                        hall()),
                              lookingEast());
  EXPECT_EQ(count(picture, kGreen), 0);
  EXPECT_EQ(count(picture, kRed), 64);
}

TEST(Sprites, thatCrossHideEachOtherColumnByColumn) {
  const Image picture = drawn(
      levelWith("{'sprite':'#00c800','x':4.5,'y':0,'size':[2,1],'facing':'angle','angle':150},"
                "{'sprite':'#c80000','x':4.5,'y':0,'size':[2,1],'facing':'angle','angle':210}",
                hall()),
      lookingEast());
  // To the left of the middle the first is nearer, to its right the second.
  EXPECT_EQ(picture.at(28, 44), kGreen);
  EXPECT_EQ(picture.at(36, 44), kRed);
}

TEST(Sprites, thatStandInOneThatLiesDivideIt) {
  const LoadedLevel loaded = levelWith(
      "{'sprite':'#00c800','x':4.5,'y':0,'z':1,'size':[3,3],'facing':'flat'},"
      "{'sprite':'#c80000','x':4.5,'y':0,'size':[1,2]}",
      hall());
  const Image picture = drawn(loaded, lookingEast());
  // 1 m below the eye, from 2.5 to 5.5 m deep: rows 37.8 to 44.8; at 4 m row 40.
  EXPECT_EQ(picture.at(32, 38), kRed) << "before the far half";
  EXPECT_EQ(picture.at(32, 42), kGreen) << "behind the near half";
  EXPECT_EQ(picture.at(32, 46), kRed) << "its foot, below what lies";
}

TEST(Sprites, inAWallShowOnItAndBehindItDoNot) {
  const auto picture = [](std::string_view x) {
    return drawn(levelWith(fmt::format("{{'sprite':'#c80000','x':{},'y':0,'z':1.5,'size':[1,1],"
                                       "'facing':'angle','angle':180}}",
                                       x),
                           hall()),
                 lookingEast());
  };
  EXPECT_GT(count(picture("8"), kRed), 0);
  EXPECT_EQ(count(picture("8"), kRed), count(picture("7.9999"), kRed));
}

TEST(Sprites, reachNoSectorThroughAWall) {
  // Two rooms side by side without an opening; half of the sprite is in the wall between.
  const std::string rooms = sectorText("a", "0,-4, 8,-4, 8,0.1, 0,0.1", 0, 4) + "," +
                            sectorText("b", "0,0.1, 8,0.1, 8,4, 0,4", 0, 4);
  const LoadedLevel loaded = levelWith("{'sprite':'#c80000','x':4.5,'y':0,'size':[2,1]}", rooms);
  const Image fromA = drawn(loaded, lookingEast());
  EXPECT_GT(count(fromA, kRed), 0);
  Camera camera = lookingEast();
  camera.sector = SectorId(1);
  camera.eye.y = 2;
  EXPECT_EQ(count(drawn(loaded, camera), kRed), 0);
}

TEST(Sprites, showTheSideThatTheEyeSeesAndTheFrameOfTheTime) {
  const LoadedLevel sides =
      levelWith("{'sprite':['#c80000','#00c800'],'x':4.5,'y':0,'size':[1,1],'angle':180}", hall());
  EXPECT_GT(count(drawn(sides, lookingEast()), kRed), 0);
  Camera fromBehind = lookingEast(7.5);
  fromBehind.angle = 180;
  EXPECT_GT(count(drawn(sides, fromBehind), kGreen), 0);

  const LoadedLevel frames =
      levelWith("{'frames':['#c80000','#00c800'],'fps':2,'x':4.5,'y':0,'size':[1,1]}", hall());
  for (const auto& [seconds, color] :
       {std::pair(0.0, kRed), {0.49, kRed}, {0.5, kGreen}, {1.0, kRed}}) {
    Camera camera = lookingEast();
    camera.seconds = seconds;
    EXPECT_GT(count(drawn(frames, camera), color), 0) << seconds;
  }
}

/// A sprite of an image of 4 x 4 texels, each in a colour of its own, without its outermost texels
/// on the opposite sides.
TEST(Sprites, showNoTexelBeyondTheEdgesOfTheirImage) {
  const LoadedLevel loaded =
      levelWith("{'sprite':'#c80000','x':2.5,'y':0,'z':1,'size':[2,2]}", hall());
  std::vector<Image> images;
  for (const Image& image : loaded.textures) images.push_back(image);
  Image& texels = images[loaded.level.sprites[0].frames[0][0].texture.index()];
  texels = Image(4, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      texels.at(x, y) = {static_cast<std::uint8_t>(200 + x), 0, static_cast<std::uint8_t>(200 + y)};
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const Renderer renderer(loaded.scene(), images, light);
  // Centres of pixels lie on the edges of texels: 16 pixels a metre, the eye off by half a pixel.
  Camera camera = lookingEast();
  for (const double shift : {0.0, 1.0 / 32, -1.0 / 32}) {
    camera.eye = {0.5, shift, 2 + shift};
    const Image picture = renderer.draw(camera, LightMode::None);
    int before = 0;
    for (int row = 16; row < 48; ++row)
      for (int column = 0; column < kSize; ++column) {
        const Rgb pixel = picture.at(column, row);
        if (pixel.b < 200 || pixel.g != 0) continue;
        ASSERT_GE(pixel.b - 200, before) << column << ' ' << row;
        before = pixel.b - 200;
        const bool isFirstHalf = column < 32;
        ASSERT_EQ(pixel.r - 200 < 2, isFirstHalf || (shift > 0 && column < 32)) << column;
        break;
      }
  }
}

TEST(Sprites, haveTheSamePixelsOnAnyNumberOfThreads) {
  std::string things;
  for (int i = 0; i < 40; ++i)
    things += fmt::format(
        "{}{{'sprite':'#{:02x}{:02x}40','x':{},'y':{},'size':[1,{}],'facing':'{}',"
        "'angle':{}}}",
        i > 0 ? "," : "", 6 * i, 255 - 6 * i, 1.05 + 0.17 * i, -3 + 0.151 * i, 0.5 + 0.04 * i,
        i % 3 == 0   ? "camera"
        : i % 3 == 1 ? "angle"
                     : "flat",
        37 * i);
  std::string text = halves();
  const LoadedLevel loaded = levelWith(things, text);
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const Renderer renderer(loaded.scene(), loaded.textures, light);
  Camera camera = lookingEast();
  camera.width = 333;
  const Image alone = renderer.draw(camera, LightMode::Both);
  Workers workers(3);
  FrameScratch scratch;
  PixelBuffer memory;
  const PixelRows rows = memory.rows(camera.width, camera.height);
  renderer.draw(camera, LightMode::Both, scratch, rows, &workers);
  EXPECT_EQ(imageOf(rows), alone);
}

TEST(Sprites, takeTheLightOfTheirPointOfAir) {
  const std::string dark = "'light':0,";
  const auto loaded =
      test::levelFrom(fmt::format("{{'things':[{{'sprite':'#ffffff','x':4,'y':0,'size':[1,2]}},"
                                  "{{'sprite':'#ffffff','x':6,'y':3,'size':[1,2],'bright':true}}],"
                                  "'sectors':{{{}}}}}",
                                  hall()),
                      "[{'x':4,'y':0,'z':3,'intensity':100,'falloff':0.5,'color':'#ff0000'},"
                      " {'x':4,'y':2,'z':1,'intensity':30}]");
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const std::optional<Lightmap>& map = light.lightmaps[loaded.level.sprites[0].surface.index()];
  ASSERT_TRUE(map);
  ASSERT_EQ(map->channels, 3);
  EXPECT_EQ(map->at(0, 0, 0), 80) << "100 / (1 + 2 * 0.5) + 30";
  EXPECT_EQ(map->at(0, 0, 1), 30);
  const Image picture = drawn(loaded, lookingEast());
  EXPECT_EQ(count(picture, (Rgb{80, 30, 30})), 10 * 18) << "3.5 m deep";
  EXPECT_GT(count(picture, (Rgb{255, 255, 255})), 0) << "the bright one";
}

TEST(Sprites, takeNoLightThroughWhatHangsInThePlaneThatTheyStandIn) {
  // On the far side of a curtain, and on the near side.
  const auto loaded = test::levelFrom(
      fmt::format("{{'things':[{{'sprite':'#ffffff','x':4,'y':0,'sector':'east'}},"
                  "{{'sprite':'#ffffff','x':4,'y':0,'sector':'west'}}],'sectors':{{{}}}}}",
                  halves(",'middle':{'name':'#c80000','scale':[8,4]}")),
      "[{'x':2,'y':0.1,'z':1,'intensity':100}]");
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const auto levelOf = [&](std::size_t sprite) {
    const auto& map = light.lightmaps[loaded.level.sprites[sprite].surface.index()];
    return map ? map->at(0, 0, 0) : 0;
  };
  EXPECT_EQ(levelOf(0), 0);
  EXPECT_EQ(levelOf(1), 100);
}

TEST(Sprites, keepTheirLightInSavedBakesAndFromBakeToBake) {
  const auto loaded = test::levelFrom(
      fmt::format("{{'things':[{{'sprite':'#ffffff','x':4,'y':0,'size':[1,2]}}],'sectors':{{{}}}}}",
                  hall()),
      "[{'x':4,'y':0,'z':3,'intensity':100,'falloff':0.5,'radius':0.2}]");
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  const std::size_t surface = loaded.level.sprites[0].surface.index();
  ASSERT_TRUE(light.lightmaps[surface]);
  const auto saved = decodeBake(
      loaded.scene(), encodeBake(loaded.scene(), light, loaded.level.bake.texel, ""), 1 << 30);
  ASSERT_TRUE(saved) << saved.error().what;
  EXPECT_EQ(saved->lightmaps[surface]->levels, light.lightmaps[surface]->levels);

  LightMemory memory;
  const auto again = Rebake(memory, loaded.scene(), loaded.level.bake, 2).finish();
  ASSERT_TRUE(again);
  EXPECT_EQ(again->lightmaps[surface]->levels, light.lightmaps[surface]->levels);
}

}  // namespace
}  // namespace hearth
