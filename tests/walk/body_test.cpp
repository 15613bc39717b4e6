#include "walk/body.h"

#include <fmt/format.h>

#include <cmath>

#include "math/tolerance.h"
#include "math/trig.h"
#include "walks.h"

namespace hearth {
namespace {

using test::after;
using test::kForward;
using test::kRun;
using test::kSolid;
using test::sectorText;
using test::standing;

std::string to(const std::string& next) {
  return fmt::format("{{'texture':'#808080','next':'{}'}}", next);
}

/// A row of rooms along x, each 4 m long and `width` m wide, open to each other in full.
struct Room {
  double floor = 0;
  double ceiling = 4;
  std::string more = {};
};

LoadedLevel row(const std::vector<Room>& rooms, double width = 4, const std::string& player = "") {
  std::string text = "{'light':1," + player + "'sectors':{";
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const double x0 = 4.0 * static_cast<double>(i);
    const std::string v = fmt::format("{0},0, {1},0, {1},{2}, {0},{2}", x0, x0 + 4, width);
    const std::string east = i + 1 < rooms.size() ? to(fmt::format("r{}", i + 1)) : kSolid;
    const std::string west = i > 0 ? to(fmt::format("r{}", i - 1)) : kSolid;
    text += (i > 0 ? "," : "") +
            sectorText(fmt::format("r{}", i), v, rooms[i].floor, rooms[i].ceiling,
                       "[" + kSolid + "," + east + "," + kSolid + "," + west + "]", rooms[i].more);
  }
  return test::levelFrom(text + "}}");
}

/// One room of any outline.
LoadedLevel room(const std::string& vertices) {
  return test::levelFrom("{'light':1,'sectors':{" + sectorText("room", vertices, 0, 4) + "}}");
}

/// Two rooms one above the other, from -5 to 0 and from 0 to 4 m, open to each other in full.
LoadedLevel storeys() {
  const std::string loops = "'loops':{'border':{'v':[0,0, 4,0, 4,4, 0,4],'walls':" + kSolid + "}}}";
  return test::levelFrom(
      "{'light':1,'sectors':{'up':{'floor':{'z':0,'next':'up-low'},'ceiling':{'z':4,'texture':'#"
      "808080'}," +
      loops + ",'low':{'floor':{'z':-5,'texture':'#808080'},'ceiling':{'z':0,'next':'up-low'}," +
      loops + "}}");
}

TEST(Body, ClimbsAStepAndNotACentimetreMore) {
  for (const double step : {0.4, 0.41}) {
    const LoadedLevel loaded = row({{}, {step}});
    const Walker walker =
        after(loaded.scene(), standing(loaded.scene(), "r0", {2, 2, 0}), kRun, 128);
    if (step == 0.4) {
      EXPECT_EQ(walker.feet.z, 0.4);
      EXPECT_NEAR(walker.feet.x, 8 - 0.3, 1e-4);
    } else {
      EXPECT_EQ(walker.feet.z, 0);
      EXPECT_NEAR(walker.feet.x, 4 - 0.3, 1e-4) << "the edge of the body is at the step";
    }
  }
}

TEST(Body, JumpsOntoWhatIsAJumpAndAStepHigh) {
  for (const double ledge : {0.9, 1.0}) {
    const LoadedLevel loaded = row({{}, {ledge}});
    WalkInput input = kForward;
    input.jump = true;
    const Walker walker =
        after(loaded.scene(), standing(loaded.scene(), "r0", {2, 2, 0}), input, 256);
    EXPECT_EQ(walker.feet.x > 4, ledge == 0.9) << ledge;
  }
}

TEST(Body, StandsOnTheHighestFloorUnderItsFootprint) {
  const LoadedLevel loaded = row({{1}, {0}});
  Walker walker = standing(loaded.scene(), "r0", {3.5, 2, 1});
  while (walker.feet.x < 4.05) walker = walked(loaded.scene(), walker, kForward);
  walker = after(loaded.scene(), walker, {}, 64);
  EXPECT_EQ(loaded.level[walker.sector].name, "r1") << "the body's axis is beyond the edge";
  EXPECT_LT(walker.feet.x, 4.3);
  EXPECT_EQ(walker.feet.z, 1);
  EXPECT_TRUE(walker.isOnGround);
  walker = after(loaded.scene(), walker, kForward, 64);
  EXPECT_EQ(walker.feet.z, 0);
}

TEST(Body, WalksDownStairsWithoutLeavingTheGround) {
  const LoadedLevel loaded = row({{1.2}, {0.9}, {0.5}, {0.2}, {0.2}});
  Walker walker = standing(loaded.scene(), "r0", {2, 2, 1.2});
  for (int i = 0; i < 300; ++i) {
    walker = walked(loaded.scene(), walker, kRun);
    ASSERT_TRUE(walker.isOnGround) << i;
  }
  EXPECT_EQ(walker.feet.z, 0.2);
}

TEST(Body, NeedsHeadRoomUnderItsWholeHead) {
  for (const double ceiling : {1.8, 1.75}) {
    const LoadedLevel loaded = row({{}, {0, ceiling}, {}});
    Walker walker = standing(loaded.scene(), "r0", {2, 2, 0});
    walker = after(loaded.scene(), walker, kRun, 192);
    EXPECT_NEAR(walker.feet.x, ceiling < 1.8 ? 3.7 : 11.7, 1e-4);
  }
}

TEST(Body, CrouchesThroughAHoleAndStandsUpBehindIt) {
  const LoadedLevel loaded = row({{}, {0, 1}, {}});
  Walker walker = standing(loaded.scene(), "r0", {3, 2, 0});
  WalkInput crouched = kForward;
  crouched.crouch = true;
  walker = after(loaded.scene(), walker, crouched, 160);
  EXPECT_GT(walker.feet.x, 4.5);
  walker = after(loaded.scene(), walker, {}, 64);
  EXPECT_NEAR(bodyOf(loaded.level, walker.crouch).height, 1, 0.12) << "as far up as there is room";
  walker = after(loaded.scene(), walker, kForward, 300);
  EXPECT_GT(walker.feet.x, 8.3);
  EXPECT_EQ(walker.crouch, 0);
}

TEST(Body, SlidesAlongAWallByTheCosine) {
  const LoadedLevel loaded = room("0,0, 60,0, 60,60, 0,60");
  for (const double angle : {-10, -30, -60, -85}) {
    Walker walker = standing(loaded.scene(), "room", {30, 0.5, 0}, angle);
    walker = after(loaded.scene(), walker, kForward, 192);
    const double x = walker.feet.x;
    walker = after(loaded.scene(), walker, kForward, 64);
    EXPECT_NEAR(walker.feet.x - x, 2.5 * sinCosDegrees(angle).cos, 1e-6) << angle;
    EXPECT_NEAR(walker.feet.y, 0.3, 2e-6);
  }
}

TEST(Body, ComesToRestInCornersOfAnyAngle) {
  for (const double angle : {1.0, 30.0, 90.0, 120.0}) {
    const SinCos side = sinCosDegrees(angle);
    const LoadedLevel loaded = room(fmt::format("0,0, 60,0, {},{}", 60 * side.cos, 60 * side.sin));
    const SinCos half = sinCosDegrees(angle / 2);
    const double from = 0.3 / half.sin + 0.5;
    if (from > 55) continue;
    for (const double off : {-20.0, 0.0, 7.0}) {
      Walker walker = standing(loaded.scene(), "room", {from * half.cos, from * half.sin, 0},
                               angle / 2 + 180 + off);
      walker = after(loaded.scene(), walker, kRun, 300);
      for (int i = 0; i < 100; ++i) {
        const Walker next = walked(loaded.scene(), walker, kRun);
        EXPECT_LT(length(next.feet - walker.feet), 1e-9) << angle << ' ' << off << ' ' << i;
        walker = next;
      }
      // At rest against what the body pushes into, and nowhere nearer to it than its radius.
      EXPECT_GE(walker.feet.y, 0.3 - 1e-9);
    }
  }
}

TEST(Body, KeepsItsRadiusOffAVertexThatItSeesNoWallOfFromTheFront) {
  // 256 degrees of a and 190 of b meet in 0,0, so that both have the place north-east of it. From
  // south-west the walls that end there, northwards in a and eastwards in b, are seen from behind.
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" +
      sectorText("a", "-4,-4, 4,-4, 4,4, 1,4, 0,0, -4,0", 0, 3,
                 "[" + kSolid + "," + kSolid + "," + kSolid + "," + kSolid + "," + to("b") + "," +
                     kSolid + "]") +
      "," +
      sectorText("b", "-4,0, 0,0, 4,-0.7, 4,4, -4,4", 0, 3,
                 "[" + to("a") + "," + kSolid + "," + kSolid + "," + kSolid + "," + kSolid + "]") +
      "}}");
  const Scene scene = loaded.scene();
  struct Way {
    std::string sector;
    Vec3 feet;
    double angle;
  };
  for (const Way& way : {Way{"a", {-2, -0.15, 0}, 0}, Way{"a", {-2, -0.5, 0}, 15},
                         Way{"b", {-2, 0.5, 0}, -20}, Way{"b", {-1, 0.5, 0}, -35}}) {
    Walker walker = standing(scene, way.sector, way.feet, way.angle);
    double nearest = 4;
    for (int i = 0; i < 128; ++i) {
      walker = after(scene, walker, kRun, 1);
      nearest = std::min(nearest, length(walker.feet.xy()));
    }
    EXPECT_GE(nearest, 0.3) << way.sector << ' ' << way.angle;
    // A tick's way along the tangent of the body takes it off again by (5/64)^2 / (2 * 0.3) m.
    EXPECT_LT(nearest, 0.3102) << "the body does touch it";
    EXPECT_GT(walker.feet.x, 0.3) << "the body slides past";
  }
}

TEST(Body, SlidesEvenlyAlongARoundWall) {
  std::string vertices;
  constexpr int kWalls = 100;
  for (int i = 0; i < kWalls; ++i) {
    const SinCos at = sinCosDegrees(360.0 * i / kWalls);
    vertices += fmt::format("{}{},{}", i > 0 ? ", " : "", 5 * at.cos, 5 * at.sin);
  }
  const LoadedLevel loaded = room(vertices);
  Walker walker = standing(loaded.scene(), "room", {4.5, 0, 0}, 60);
  // He looks 30 degrees into the wall all the way round, and slides after a while.
  for (int i = -32; i < 640; ++i) {
    walker.angle = compassDegrees(turned90(walker.feet.xy())) - 30;
    const Walker next = walked(loaded.scene(), walker, kForward);
    const double speed = 64 * length(next.feet - walker.feet);
    if (i >= 0) {
      EXPECT_NEAR(speed, 2.5 * std::sqrt(0.75), 0.1) << i;
    }
    walker = next;
  }
}

TEST(Body, SlidesPastVerticesOfAStraightWall) {
  std::string vertices = "30,4, 0,4";
  for (int i = 0; i <= 300; ++i) vertices += fmt::format(", {},0", 0.1 * i);
  const LoadedLevel loaded = room(vertices);
  Walker walker = standing(loaded.scene(), "room", {1, 0.5, 0}, -45);
  walker = after(loaded.scene(), walker, kForward, 128);
  const double x = walker.feet.x;
  walker = after(loaded.scene(), walker, kForward, 256);
  EXPECT_NEAR(walker.feet.x - x, 4 * 2.5 * std::sqrt(0.5), 1e-3);
}

TEST(Body, WalksSlopesUpAndDownWithoutLeavingTheGround) {
  const std::string up = ", 'slopeFloor':{'z':[0,2,null,0],'sidewall':'#808080'}";
  const std::string down = ", 'slopeFloor':{'z':[2,0,null,2],'sidewall':'#808080'}";
  const LoadedLevel loaded = row({{}, {0, 6, up}, {0, 6, down}, {}});
  Walker walker = standing(loaded.scene(), "r0", {2, 2, 0});
  double highest = 0;
  for (int i = 0; i < 250; ++i) {
    walker = walked(loaded.scene(), walker, kRun);
    ASSERT_TRUE(walker.isOnGround) << i << ' ' << walker.feet.x << ' ' << walker.feet.z;
    highest = std::max(highest, walker.feet.z);
  }
  EXPECT_NEAR(highest, 2, 0.1);
  EXPECT_GT(walker.feet.x, 15);
  EXPECT_EQ(walker.feet.z, 0);
}

TEST(Body, IsStoppedBySlopesSteeperThan45Degrees) {
  for (const double rise : {3.9, 4.1}) {
    const std::string slope =
        fmt::format(", 'slopeFloor':{{'z':[0,{},null,0],'sidewall':'#808080'}}", rise);
    const LoadedLevel loaded = row({{}, {0, 9, slope}});
    Walker walker = standing(loaded.scene(), "r0", {2, 2, 0});
    walker = after(loaded.scene(), walker, kForward, 300);
    if (rise < 4) {
      EXPECT_GT(walker.feet.z, 3);
    } else {
      EXPECT_EQ(walker.feet.z, 0);
    }
  }
}

TEST(Body, StopsWhereASlopeComesDownToItsHead) {
  const std::string slope = ", 'slopeCeil':{'z':[0,3.5,null,0],'sidewall':'#808080'}";
  const LoadedLevel loaded = row({{}, {0, 4, slope}});
  Walker walker = standing(loaded.scene(), "r0", {2, 2, 0}, 30);
  walker = after(loaded.scene(), walker, kForward, 300);
  const double room = loaded.scene().airTop(loaded.level.sectors[1], {walker.feet.x + 0.3, 2});
  EXPECT_NEAR(room, 1.8, 1e-4);
  EXPECT_NEAR(walker.feet.y, 3.7, 1e-4) << "the body slides along the slope to the wall";
}

TEST(Body, FallsThroughAFlatPortalAndFliesBackUp) {
  const LoadedLevel loaded = storeys();
  const Scene scene = loaded.scene();
  Walker walker = walkerAt(scene, SectorId(0), {2, 2, 2}, 0, 0);
  EXPECT_EQ(scene[walker.sector].name, "up");
  bool wasSplit = false;
  for (int i = 0; i < 200; ++i) {
    walker = after(scene, walker, {}, 1);
    wasSplit = wasSplit || eyeOf(scene, walker).sector != walker.sector;
  }
  EXPECT_TRUE(wasSplit) << "the eye is above the portal when the feet are below";
  EXPECT_EQ(scene[walker.sector].name, "low");
  EXPECT_EQ(walker.feet.z, -5);
  walker = walked(scene, walker, {.up = 127, .toggleFlight = true});
  walker = after(scene, walker, {.up = 127}, 200);
  EXPECT_EQ(scene[walker.sector].name, "up");
  EXPECT_NEAR(walker.feet.z, 4 - 1.8, 1e-5);
}

TEST(Body, WithoutBreadthHasACeilingBeyondAFlatPortalAlsoWhereItMissesBothRoomsByTheSlack) {
  LoadedLevel loaded = storeys();
  loaded.level.player.emplace();
  loaded.level.player->height = 6;
  loaded.level.player->radius = 0;
  const Scene scene = loaded.scene();
  Walker walker{test::sectorNamed(loaded.level, "low"), {-kPositionSlack / 2, 2, -4}, {}};
  walker = walked(scene, walker, {.up = 127, .toggleFlight = true});
  walker = after(scene, walker, {.up = 127}, 200);
  EXPECT_NEAR(walker.feet.z, 4 - 6, 1e-5);
}

TEST(Body, GoesThroughAOneWayPortalAndNotBack) {
  const std::string east = "[" + kSolid + "," + to("b") + "," + kSolid + "," + kSolid + "]";
  const LoadedLevel loaded =
      test::levelFrom("{'light':1,'sectors':{" + sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3, east) +
                      "," + sectorText("b", "4,0, 8,0, 8,4, 4,4", 0, 3) + "}}");
  Walker walker = standing(loaded.scene(), "a", {3, 2, 0});
  walker = after(loaded.scene(), walker, kForward, 128);
  EXPECT_EQ(loaded.level[walker.sector].name, "b");
  walker = after(loaded.scene(), walker, {.forward = -127}, 256);
  EXPECT_EQ(loaded.level[walker.sector].name, "b");
  EXPECT_NEAR(walker.feet.x, 4.3, 1e-4);
}

TEST(Body, IsNotStoppedByTheJointOfAOneWayPortalAndAnotherPortal) {
  // From behind, 5,2 is a corner of b that juts out, between a wall and a portal; but from a both
  // sides of it are open.
  const std::string west =
      "[" + kSolid + "," + kSolid + "," + kSolid + "," + kSolid + "," + to("a") + "]";
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" +
      sectorText("a", "0,0, 4,0, 5,2, 4,4, 0,4", 0, 3,
                 "[" + kSolid + "," + to("b") + "," + to("b") + "," + kSolid + "," + kSolid + "]") +
      "," + sectorText("b", "4,0, 8,0, 8,4, 4,4, 5,2", 0, 3, west) + "}}");
  Walker walker = standing(loaded.scene(), "a", {3, 2.05, 0});
  walker = after(loaded.scene(), walker, kForward, 160);
  EXPECT_EQ(loaded.level[walker.sector].name, "b");
  EXPECT_NEAR(walker.feet.x, 7.7, 1e-4);
  EXPECT_NEAR(walker.feet.y, 2.05, 1e-9);
}

TEST(Body, StandsOnAFenceBetweenTwoSectors) {
  const std::string fence =
      "{'walls':[{'z':0.35,'texture':'#808080'},{'texture':'#808080','next':'NEXT'}]}";
  const auto fenceTo = [&](const std::string& next) {
    return std::string(fence).replace(fence.find("NEXT"), 4, next);
  };
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" +
      sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3,
                 "[" + kSolid + "," + fenceTo("b") + "," + kSolid + "," + kSolid + "]") +
      "," +
      sectorText("b", "4,0, 8,0, 8,4, 4,4", 0, 3,
                 "[" + kSolid + "," + kSolid + "," + kSolid + "," + fenceTo("a") + "]") +
      "}}");
  Walker walker = standing(loaded.scene(), "a", {3, 2, 0});
  while (walker.feet.x < 4) walker = walked(loaded.scene(), walker, kForward);
  walker = after(loaded.scene(), walker, {}, 32);
  EXPECT_EQ(walker.feet.z, 0.35);
  EXPECT_EQ(after(loaded.scene(), walker, kForward, 128).feet.z, 0);
}

TEST(Body, PassesNothingInALevelOfAThousandth) {
  // At 5 m/s a tick is 78 body lengths of this level.
  const std::string player =
      "'player':{'sector':'a','x':0.002,'y':0.002,'z':0.0016,'height':0.0018,'eye':0.0016,"
      "'radius':0.0003,'step':0.0004},";
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1," + player + "'sectors':{" +
      sectorText("a", "0,0, 0.004,0, 0.004,0.004, 0,0.004", 0, 0.003,
                 "[" + kSolid + "," + to("b") + "," + kSolid + "," + kSolid + "]") +
      "," +
      sectorText("b", "0.004,0, 0.005,0, 0.005,0.004, 0.004,0.004", 0, 0.003,
                 "[" + kSolid + "," + kSolid + "," + kSolid + "," + to("a") + "]") +
      "," + sectorText("c", "0.005,0, 0.3,0, 0.3,0.004, 0.005,0.004", 0, 0.003) + "}}");
  for (const double angle : {0.0, 10.0, -30.0, 90.0, 179.0}) {
    Walker walker = standing(loaded.scene(), "a", {0.002, 0.002, 0}, angle);
    walker = after(loaded.scene(), walker, kRun, 64);
    EXPECT_NE(loaded.level[walker.sector].name, "c");
    if (angle == 0) {
      EXPECT_NEAR(walker.feet.x, 0.0047, 3e-6);
    }
  }
}

TEST(Body, StaysWhereItIsStuck) {
  for (const double ceiling : {0.0, 0.5, 0.89}) {
    const LoadedLevel loaded = row({{0, ceiling}, {}});
    Walker walker = walkerAt(loaded.scene(), SectorId(0), {2, 2, ceiling / 2}, 0, 0);
    const Vec3 start = walker.feet;
    walker = after(loaded.scene(), walker, kRun, 64);
    walker = after(loaded.scene(), walker, {.up = 127, .jump = true, .toggleFlight = true}, 64);
    EXPECT_EQ(walker.feet, start) << ceiling;
  }
}

TEST(Body, LeavesATooNarrowPlaceAndNeverGoesDeeper) {
  const LoadedLevel loaded = row({{}, {}}, 0.4);
  Walker walker = walkerAt(loaded.scene(), SectorId(0), {2, 0.2, 1.6}, 90, 0);
  walker = after(loaded.scene(), walker, kRun, 64);
  EXPECT_NEAR(walker.feet.y, 0.2, 1e-9);
}

}  // namespace
}  // namespace hearth
