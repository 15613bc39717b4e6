// Meshes stop light: on floors and walls, on one another, and on points of the air.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "support/baked_room.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::kBoxModel;
using test::kPanelModel;
using test::levelFrom;
using test::sectorText;

/// A hall of 12 by 8 m, 6 m high, whose light is 255 everywhere that the lamp in it sees.
LoadedLevel hallWith(std::string_view things, std::string_view lights,
                     std::string_view more = "'texel':0.1") {
  return levelFrom(fmt::format("{{'things':[{}],'sectors':{{{}}}}}", things,
                               sectorText("hall", "0,0, 12,0, 12,8, 0,8", 0, 6)),
                   fmt::format("{{'lights':[{}],'bake':{{{}}}}}", lights, more),
                   {{"box.obj", kBoxModel}, {"panel.obj", kPanelModel}});
}

constexpr std::string_view kLamp = "{'x':2,'y':4,'z':3}";

double onFloor(const BakedRoom& room, double x, double y, std::string_view sector = "") {
  return room.at(SurfaceKind::Floor, {x, y, 0}, sector);
}

/// From (2, 4, 3) over the upper edge of a box of 1 m at x = 4.5 light falls 2 m in 2.5 m: the
/// floor is dark up to x = 5.75. The rays over its far upper corners go on to y = 4 +- 0.5 * 3.75
/// / 2.5.
TEST(MeshShadow, ofABoxOnTheFloorIsItsPerspectiveImage) {
  const BakedRoom room(hallWith("{'mesh':'box.obj','x':4,'y':4}", kLamp));
  EXPECT_EQ(onFloor(room, 3.3, 4), 255);
  EXPECT_EQ(onFloor(room, 4.7, 4), 0);
  EXPECT_EQ(onFloor(room, 5.6, 4), 0);
  EXPECT_EQ(onFloor(room, 5.9, 4), 255);
  EXPECT_EQ(onFloor(room, 5.6, 4.65), 0);
  EXPECT_EQ(onFloor(room, 5.6, 4.9), 255);
}

TEST(MeshShadow, isThatOfTheSameBoxOfWalls) {
  constexpr std::string_view kAside = "{'x':2.0171,'y':4.0137,'z':3}";
  const BakedRoom box(hallWith("{'mesh':'box.obj','x':4,'y':4}", kAside));
  const BakedRoom walls(
      "{'sectors':{'hall':{'floor':{'texture':'#808080'},'ceiling':{'z':6,'texture':'#808080'},"
      "'loops':{'border':{'v':[0,0, 12,0, 12,8, 0,8],'walls':{'texture':'#808080'}},"
      "'box':{'v':[3.5,3.5, 3.5,4.5, 4.5,4.5, 4.5,3.5],'walls':{'texture':'#808080','next':'top'}}"
      "}}," +
          sectorText("top", "3.5,3.5, 4.5,3.5, 4.5,4.5, 3.5,4.5", 1, 6,
                     "{'texture':'#808080','next':'hall'}") +
          "}}",
      fmt::format("{{'lights':[{}],'bake':{{'texel':0.1}}}}", kAside));
  // Texels that the box covers in part are those of other samples.
  for (double y = 0.05; y < 8; y += 0.1)
    for (double x = 0.05; x < 12; x += 0.1)
      if (x < 3.3 || x > 4.7 || y < 3.3 || y > 4.7) {
        EXPECT_NEAR(onFloor(box, x, y, "hall"), onFloor(walls, x, y, "hall"), 1) << x << " " << y;
      }
}

TEST(MeshShadow, isNoneOfAMeshWithoutShadow) {
  const BakedRoom room(hallWith("{'mesh':'box.obj','x':4,'y':4,'shadow':false}", kLamp));
  for (double x = 0.5; x < 12; x += 0.5) EXPECT_EQ(onFloor(room, x, 4), 255);
}

TEST(MeshShadow, isCastByFacesFromBothSides) {
  for (const double angle : {0.0, 180.0}) {
    const BakedRoom room(
        hallWith(fmt::format("{{'mesh':'panel.obj','x':4,'y':4,'angle':{}}}", angle), kLamp));
    EXPECT_EQ(onFloor(room, 4.5, 4), 0) << angle;
    EXPECT_EQ(onFloor(room, 8, 4), 255) << angle;
  }
}

/// A panel of 1 m, from y = 4 on, hides a half of the ball from a point behind its edge.
TEST(MeshShadow, hidesAPartOfABallFromPointsInItsHalfShadow) {
  const BakedRoom room(hallWith("{'mesh':'panel.obj','x':4,'y':5,'scale':[1,2,9]}",
                                "{'x':2,'y':4,'z':0.5,'radius':0.4}"));
  EXPECT_NEAR(onFloor(room, 9, 4), 127.5, 8);
  EXPECT_EQ(onFloor(room, 9, 2), 255);
  EXPECT_EQ(onFloor(room, 9, 6), 0);
}

TEST(MeshShadow, fallsOnMeshesThatStandInIt) {
  const BakedRoom room(
      hallWith("{'mesh':'box.obj','x':4,'y':4},{'mesh':'box.obj','x':5.5,'y':4,"
               "'scale':[1,1,3]}",
               kLamp));
  const Vec3 west{-1, 0, 0};
  EXPECT_EQ(room.onMesh({5, 4, 0.3}, west), 0);
  EXPECT_EQ(room.onMesh({5, 4, 2}, west), 255);
}

TEST(MeshShadow, fallsOnSpritesByTheirPointOfAir) {
  const auto light = [](double x) {
    const BakedRoom room(
        hallWith("{'mesh':'box.obj','x':4,'y':4,'scale':[1,1,2]},{'sprite':'#ff0000','x':" +
                     fmt::format("{}", x) + ",'y':4,'size':[0.5,1]}",
                 kLamp));
    const auto& map = room.light().lightmaps[room.level().sprites.front().surface.index()];
    return map ? int{map->at(0, 0)} : 0;
  };
  EXPECT_EQ(light(5), 0);
  EXPECT_EQ(light(9), 255);
}

TEST(MeshShadow, fallsThroughOpeningsIntoOtherSectorsAndNotIntoThoseThatOverlap) {
  const std::string next = "{'texture':'#808080','next':'";
  const auto room = [&](std::string_view things) {
    return BakedRoom(levelFrom("{'things':[" + std::string(things) + "],'sectors':{" +
                                   sectorText("west", "0,0, 6,0, 6,8, 0,8", 0, 6,
                                              "[{'texture':'#808080'},{'next':'east'},"
                                              "{'texture':'#808080'},{'texture':'#808080'}]") +
                                   "," +
                                   sectorText("east", "6,0, 12,0, 12,8, 6,8", 0, 6,
                                              "[{'texture':'#808080'},{'texture':'#808080'},"
                                              "{'texture':'#808080'},{'next':'west'}]") +
                                   "," + sectorText("apart", "0,0, 12,0, 12,8, 0,8", 0, 6) + "}}",
                               fmt::format("{{'lights':[{{'x':2,'y':4,'z':3,'sector':'west'}}],"
                                           "'bake':{{'texel':0.1}}}}"),
                               {{"box.obj", kBoxModel}}));
  };
  const BakedRoom across = room("{'mesh':'box.obj','x':5.5,'y':4,'sector':'west'}");
  EXPECT_EQ(onFloor(across, 6.5, 4, "east"), 0);
  EXPECT_EQ(onFloor(across, 9, 4, "east"), 255);
  const BakedRoom straddling = room("{'mesh':'box.obj','x':6,'y':4,'sector':'east'}");
  EXPECT_EQ(onFloor(straddling, 7, 4, "east"), 0);
  const BakedRoom apart = room("{'mesh':'box.obj','x':5.5,'y':4,'sector':'apart'}");
  EXPECT_EQ(onFloor(apart, 6.5, 4, "east"), 255);
}

/// Light comes into "east" through a wall that leads nowhere from there, in whose plane a panel
/// stands. Rounding puts where a ray meets the panel now before, now behind where it passes.
TEST(MeshShadow, isThatOfAFaceInThePlaneOfAnOpening) {
  const BakedRoom room(levelFrom(
      "{'things':[{'mesh':'panel.obj','x':6.007,'y':4,'z':1.2,'scale':2,'sector':'east'}],"
      "'sectors':{" +
          sectorText("west", "0,0, 6.007,0, 6.007,8, 0,8", 0, 6,
                     "[{'texture':'#808080'},{'next':'east'},"
                     "{'texture':'#808080'},{'texture':'#808080'}]") +
          "," + sectorText("east", "6.007,0, 12,0, 12,8, 6.007,8", 0, 6) + "}}",
      "{'lights':[{'x':2,'y':3.9,'z':3,'sector':'west'}],'bake':{'texel':0.1}}",
      {{"panel.obj", kPanelModel}}));
  EXPECT_EQ(onFloor(room, 7, 4, "east"), 255);
  for (double x = 9; x < 12; x += 0.1)
    for (double y = 2.5; y < 5.5; y += 0.1)
      EXPECT_EQ(onFloor(room, x, y, "east"), 0) << x << ' ' << y;
}

/// On all sides of a box of 1 m in the middle of the hall light reaches what the box stands on.
constexpr std::string_view kLampsAround =
    "{'x':2,'y':2,'z':3},{'x':6,'y':2,'z':3},{'x':2,'y':6,'z':3},{'x':6,'y':6,'z':3}";

/// The least light of a flat right beside that box.
double leastAround(const BakedRoom& room, SurfaceKind kind, double z) {
  double least = 255;
  for (double along = 3.5; along <= 4.5; along += 0.05)
    for (const Vec2 p :
         {Vec2{3.49, along}, Vec2{4.51, along}, Vec2{along, 3.49}, Vec2{along, 4.51}})
      least = std::min(least, room.at(kind, {p.x, p.y, z}));
  return least;
}

/// What is dark below a box does not bleed out along its sides.
TEST(MeshShadow, leavesOutWhatLiesInsideAMesh) {
  for (const std::string_view samples : {"'texel':0.3", "'texel':0.3,'samples':4"}) {
    const BakedRoom room(hallWith("{'mesh':'box.obj','x':4,'y':4}", kLampsAround, samples));
    EXPECT_EQ(leastAround(room, SurfaceKind::Floor, 0), 255) << samples;
  }
}

/// Where two boxes meet, a ray from the floor meets the back of the one that it comes from and the
/// front of the other at one place. Rounding puts now this one, now that one first.
TEST(MeshShadow, leavesOutWhatLiesInsideAMeshOnWhichAnotherStands) {
  for (double height = 0.3; height < 1; height += 0.07) {
    const BakedRoom room(
        hallWith(fmt::format("{{'mesh':'box.obj','x':4,'y':4,'scale':[1,1,{0}]}},"
                             "{{'mesh':'box.obj','x':4,'y':4,'z':{0},'scale':[1,1,{0}]}}",
                             height),
                 kLampsAround, "'texel':0.3"));
    EXPECT_EQ(leastAround(room, SurfaceKind::Floor, 0), 255) << height;
  }
}

/// A ray from the ceiling meets the back of the box's bottom where it meets the floor.
TEST(MeshShadow, leavesOutWhatLiesInsideAMeshThatReachesThroughTheCeiling) {
  for (double floor = -1; floor < 1; floor += 0.13) {
    const BakedRoom room(
        levelFrom(fmt::format("{{'things':[{{'mesh':'box.obj','x':4,'y':4,'scale':[1,1,9]}}],"
                              "'sectors':{{{}}}}}",
                              sectorText("hall", "0,0, 12,0, 12,8, 0,8", floor, 6)),
                  fmt::format("{{'lights':[{}],'bake':{{'texel':0.3}}}}", kLampsAround),
                  {{"box.obj", kBoxModel}}));
    EXPECT_EQ(leastAround(room, SurfaceKind::Ceiling, 6), 255) << floor;
  }
}

}  // namespace
}  // namespace hearth
