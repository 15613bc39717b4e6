// Small levels, baked and read at points of the world, against values worked out by hand.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/baked_room.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

constexpr std::string_view kSolid = "{'texture':'#808080'}";

std::string levelOf(const std::string& sectors, std::string_view more = "") {
  return fmt::format("{{'light': 0{}, 'sectors': {{{}}}}}", more, sectors);
}

std::string portal(std::string_view next) {
  return fmt::format("{{'next':'{}','texture':'#808080'}}", next);
}

/// 255 at the light, half of it at 1 m.
double brightnessAt(Vec3 light, Vec3 p) { return 255 / (length(p - light) + 1); }

/// A room of 6 x 4 x 3 m at the origin, open to a second one of 4 x 4 m beyond x = 6.
std::string twoRooms(double floor, double ceiling, std::string_view moreOfSecond = "") {
  return levelOf(sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3,
                            fmt::format("[{0},{1},{0},{0}]", kSolid, portal("east"))) +
                 "," +
                 sectorText("east", "6,0, 10,0, 10,4, 6,4", floor, ceiling,
                            fmt::format("[{0},{0},{0},{1}]", kSolid, portal("west")),
                            moreOfSecond));
}

TEST(BakedRoomTest, fallsOffWithDistanceOnEverySideOfABox) {
  const Vec3 light{2, 1.5, 1.2};
  const BakedRoom room(levelOf(sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3)),
                       "[{'x':2,'y':1.5,'z':1.2,'falloff':1}]");
  for (const auto& [kind, p] : {std::pair{SurfaceKind::Floor, Vec3{4.3, 3.1, 0}},
                                std::pair{SurfaceKind::Floor, Vec3{0.4, 0.3, 0}},
                                std::pair{SurfaceKind::Ceiling, Vec3{5.2, 0.7, 3}},
                                std::pair{SurfaceKind::Solid, Vec3{0, 2.2, 1.7}},
                                std::pair{SurfaceKind::Solid, Vec3{6, 2.9, 0.3}},
                                std::pair{SurfaceKind::Solid, Vec3{3.3, 0, 2.6}},
                                std::pair{SurfaceKind::Solid, Vec3{3.3, 4, 1.1}}})
    EXPECT_NEAR(room.at(kind, p), brightnessAt(light, p), 1)
        << name(kind) << ' ' << p.x << ' ' << p.y;
}

TEST(BakedRoomTest, addsLightsAndClampsAtFull) {
  const std::string room = levelOf(sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3));
  const BakedRoom dim(room,
                      "[{'x':2,'y':2,'z':1,'intensity':60},{'x':4,'y':2,'z':1,'intensity':70}]");
  EXPECT_EQ(dim.at(SurfaceKind::Floor, {3, 1, 0}), 130);
  const BakedRoom bright(room, "[{'x':2,'y':2,'z':1},{'x':4,'y':2,'z':1}]");
  EXPECT_EQ(bright.at(SurfaceKind::Floor, {3, 1, 0}), 255);
}

TEST(BakedRoomTest, lightsBothStepsOfAPortal) {
  const Vec3 light{2, 2, 1.5};
  const BakedRoom rooms(twoRooms(0.8, 2.2), "[{'x':2,'y':2,'z':1.5,'falloff':1}]");
  const Vec3 lower{6, 1.3, 0.4};
  const Vec3 upper{6, 2.7, 2.6};
  EXPECT_NEAR(rooms.at(SurfaceKind::LowerStep, lower), brightnessAt(light, lower), 1);
  EXPECT_NEAR(rooms.at(SurfaceKind::UpperStep, upper), brightnessAt(light, upper), 1);
}

TEST(BakedRoomTest, castsAStepsShadowToWhereTheLineOverItsEdgeFalls) {
  // From 2 m height, 4 m before the opening whose lower edge is at 1 m: light comes down beyond it
  // along a line that falls 1/4, so on a floor at 0.5 it arrives 2 m beyond the step.
  const BakedRoom rooms(
      levelOf(
          sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3,
                     fmt::format("[{0},{{'walls':[{{'z':1,'texture':'#808080'}},{1}]}},{0},{0}]",
                                 kSolid, portal("east"))) +
          "," +
          sectorText("east", "6,0, 10,0, 10,4, 6,4", 0.5, 3,
                     fmt::format("[{0},{0},{0},{{'walls':[{{'z':0.5,'texture':'#808080'}},{1}]}}]",
                                 kSolid, portal("west")))),
      "[{'x':2,'y':2,'z':2,'intensity':200}]");
  EXPECT_EQ(rooms.at(SurfaceKind::Floor, {7.8, 2, 0.5}, "east"), 0);
  EXPECT_EQ(rooms.at(SurfaceKind::Floor, {8.2, 2, 0.5}, "east"), 200);
}

TEST(BakedRoomTest, lightsPiecesOfAStackWithinTheirOwnHeights) {
  const Vec3 light{3, 2, 1.5};
  const std::string stack =
      "{'walls':[{'z':1,'texture':'#808080'},{'z':1.8,'next':'east','texture':'#808080'},"
      "{'texture':'#808080'}]}";
  const BakedRoom rooms(
      levelOf(sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3,
                         fmt::format("[{0},{1},{0},{0}]", kSolid, stack)) +
              "," +
              sectorText("east", "6,0, 10,0, 10,4, 6,4", 0.9, 2,
                         fmt::format("[{0},{0},{0},{1}]", kSolid, portal("west")))),
      "[{'x':3,'y':2,'z':1.5,'falloff':1}]");
  for (const Vec3 p : {Vec3{6, 1, 0.05}, Vec3{6, 1, 0.95}, Vec3{6, 3, 1.85}, Vec3{6, 3, 2.9}})
    EXPECT_NEAR(rooms.at(SurfaceKind::StackSolid, p), brightnessAt(light, p), 1) << p.z;
}

TEST(BakedRoomTest, lightsSlopesAndTheirSidewalls) {
  const Vec3 light{2, 2, 2.5};
  const BakedRoom rooms(twoRooms(0, 3, ",'slopeFloor':{'z':[1,0,0,1],'sidewall':'#808080'}"),
                        "[{'x':2,'y':2,'z':2.5,'falloff':1}]");
  const Vec3 side{6, 1.2, 0.6};
  const Vec3 slope{8, 2.5, 0.5};
  EXPECT_NEAR(rooms.at(SurfaceKind::FloorSidewall, side), brightnessAt(light, side), 1);
  EXPECT_NEAR(rooms.at(SurfaceKind::SlopeFloor, slope), brightnessAt(light, slope), 1);
}

TEST(BakedRoomTest, stopsLightAtASlope) {
  // The crest of the wedge, 1.5 m high at x = 6, is 5 m before a light at 0.2 m: on the wall 4 m
  // beyond, light arrives above 0.2 + 1.3 * 9/5 = 2.54 m, and none on the slope that falls away.
  const BakedRoom rooms(twoRooms(0, 3, ",'slopeFloor':{'z':[1.5,0,0,1.5],'sidewall':'#808080'}"),
                        "[{'x':1,'y':2,'z':0.2,'intensity':200}]");
  EXPECT_EQ(rooms.at(SurfaceKind::Solid, {10, 2, 2.75}, "east"), 200);
  EXPECT_EQ(rooms.at(SurfaceKind::Solid, {10, 2, 2.35}, "east"), 0);
  EXPECT_EQ(rooms.at(SurfaceKind::SlopeFloor, {8, 2, 0.75}, "east"), 0);
  EXPECT_EQ(rooms.at(SurfaceKind::FloorSidewall, {6, 2, 1.2}), 200);
}

TEST(BakedRoomTest, givesNoLightToTheSurfaceThatALightLiesIn) {
  const std::string room = levelOf(sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3));
  const BakedRoom onFloor(room, "[{'x':3,'y':2,'z':0}]");
  EXPECT_EQ(onFloor.at(SurfaceKind::Floor, {4, 3, 0}), 0);
  EXPECT_EQ(onFloor.at(SurfaceKind::Ceiling, {4, 3, 3}), 255);
  const BakedRoom onWall(room, "[{'x':6,'y':2,'z':1}]");
  EXPECT_EQ(onWall.at(SurfaceKind::Solid, {6, 3, 1}), 0);
  EXPECT_EQ(onWall.at(SurfaceKind::Solid, {0, 3, 1}), 255);
  EXPECT_EQ(onWall.at(SurfaceKind::Floor, {3, 3, 0}), 255);
}

TEST(BakedRoomTest, letsLightThroughOneWayPortalsOnlyTheirWay) {
  const std::string rooms =
      levelOf(sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3,
                         fmt::format("[{0},{1},{0},{0}]", kSolid, portal("east"))) +
              "," + sectorText("east", "6,0, 10,0, 10,4, 6,4", 0, 3));
  const BakedRoom fromWest(rooms, "[{'x':2,'y':2,'z':1.5}]");
  EXPECT_EQ(fromWest.at(SurfaceKind::Solid, {10, 2, 1}, "east"), 255);
  const BakedRoom fromEast(rooms, "[{'x':8,'y':2,'z':1.5}]");
  EXPECT_EQ(fromEast.at(SurfaceKind::Solid, {0, 2, 1}, "west"), 0);
  EXPECT_EQ(fromEast.at(SurfaceKind::Solid, {6, 2, 1}, "east"), 255);
}

std::string skyRooms(double eastCeiling, bool eastSky) {
  return fmt::format(
      "{{'light':0,'textures':'{}','sectors':{{'west':{{'ceiling':{{'z':3,'texture':'sky',"
      "'parallax':true}},'floor':{{'texture':'#808080'}},'loops':{{'border':{{'v':[0,0, 6,0, 6,4, "
      "0,4],'walls':[{{'texture':'#808080'}},{{'next':'east','texture':'#808080'}},{{'texture':"
      "'#808080'}},{{'texture':'#808080'}}]}}}}}},'east':{{'ceiling':{{'z':{},'texture':'sky',"
      "'parallax':{}}},'floor':{{'texture':'#808080'}},'loops':{{'border':{{'v':[6,0, 10,0, 10,4, "
      "6,4],'walls':[{{'texture':'#808080'}},{{'texture':'#808080'}},{{'texture':'#808080'}},"
      "{{'next':'west','texture':'#808080'}}]}}}}}}}}}}",
      test::inTree("textures").string(), eastCeiling, eastSky);
}

TEST(BakedRoomTest, letsLightPassSkies) {
  const std::string light = "[{'x':2,'y':2,'z':9,'sector':'west','intensity':200}]";
  const BakedRoom underSkies(skyRooms(2, true), light);
  EXPECT_EQ(underSkies.at(SurfaceKind::Floor, {3, 3, 0}, "west"), 200);
  EXPECT_EQ(underSkies.at(SurfaceKind::Floor, {9, 2, 0}, "east"), 200)
      << "over the step between the skies";
  const BakedRoom besideARoof(skyRooms(2, false), light);
  EXPECT_EQ(besideARoof.at(SurfaceKind::Floor, {3, 3, 0}, "west"), 200);
  EXPECT_EQ(besideARoof.at(SurfaceKind::Floor, {9, 2, 0}, "east"), 0)
      << "a roof has an end to its opening";
}

TEST(BakedRoomTest, shinesThroughFlatPortalsToTheSectorThatIsThere) {
  const std::string level =
      "{'light':0,'sectors':{"
      "'up':{'floor':{'z':0,'next':'up-low'},'ceiling':{'z':3,'texture':'#808080'},'loops':{'"
      "border':"
      "{'v':[0,0, 4,0, 4,4, 0,4],'walls':{'texture':'#808080'}}}},"
      "'low':{'floor':{'z':-3,'texture':'#808080'},'ceiling':{'z':0,'next':'up-low'},'loops':"
      "{'border':{'v':[0,0, 2,0, 2,4, 0,4],'walls':{'texture':'#808080'}}}},"
      "'lowEast':{'floor':{'z':-3,'texture':'#808080'},'ceiling':{'z':0,'next':{'up':'up','down':"
      "'low'}},'loops':{'border':{'v':[2,0, 4,0, 4,4, 2,4],'walls':{'texture':'#808080'}}}}}}";
  const BakedRoom rooms(level, "[{'x':1.9,'y':2,'z':1,'intensity':200}]");
  EXPECT_EQ(rooms.at(SurfaceKind::Floor, {1, 1, -3}, "low"), 200);
  EXPECT_EQ(rooms.at(SurfaceKind::Floor, {3, 1, -3}, "lowEast"), 200);
  EXPECT_EQ(rooms.at(SurfaceKind::Solid, {4, 1, -2}, "lowEast"), 200);
  EXPECT_EQ(rooms.at(SurfaceKind::Solid, {2, 1, -2}, "lowEast"), 0) << "faces away";
}

}  // namespace
}  // namespace hearth
