#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "halls.h"
#include "math/predicates.h"
#include "walk/body.h"

/// Meshes are solid to the player in the convex hull of their plan, between their lowest and their
/// highest point. The player's body has a radius of 0.3 m, a height of 1.8 m and a step of 0.4 m.
namespace hearth {
namespace {

using test::after;
using test::gon;
using test::kForward;
using test::kRun;
using test::kSolid;
using test::standing;

constexpr double kRadius = 0.3;

/// 1 m each way, its origin in the middle of its bottom.
constexpr std::string_view kBox =
    "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\n"
    "v -0.5 1 -0.5\nv 0.5 1 -0.5\nv 0.5 1 0.5\nv -0.5 1 0.5\n"
    "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n";

/// A square, 1 m each way, that stands upright across the x axis.
constexpr std::string_view kPanel = "v 0 0 0.5\nv 0 0 -0.5\nv 0 1 -0.5\nv 0 1 0.5\nf 1 2 3 4\n";

/// The same, of ten pieces side by side.
std::string cutPanel() {
  std::string text;
  for (int i = 0; i <= 10; ++i) text += fmt::format("v 0 0 {0}\nv 0 1 {0}\n", i / 10.0 - 0.5);
  for (int i = 1; i <= 10; ++i)
    text += fmt::format("f {} {} {} {}\n", 2 * i - 1, 2 * i, 2 * i + 2, 2 * i + 1);
  return text;
}

/// A square of 1 m that lies, its origin in the middle of one side.
constexpr std::string_view kPlank = "v 0 0 -0.5\nv 1 0 -0.5\nv 1 0 0.5\nv 0 0 0.5\nf 1 2 3 4\n";

LoadedLevel hallWith(const std::string& things, double ceiling = 4) {
  return test::hallWith(things, ceiling,
                        {{"box.obj", kBox},
                         {"panel.obj", kPanel},
                         {"cut_panel.obj", cutPanel()},
                         {"triangle.obj", gon(3)},
                         {"gon.obj", gon(1000)}});
}

LoadedLevel roomsWith(const std::string& things, const std::string& toEast,
                      const std::string& toWest) {
  return test::roomsWith(things, toEast, toWest, {{"box.obj", kBox}, {"panel.obj", kPanel}});
}

std::string mesh(const std::string& model, double x, double y, double z = 0,
                 const std::string& more = "") {
  return fmt::format("{{'mesh':'{}.obj','x':{},'y':{},'z':{}{}{}}}", model, x, y, z,
                     more.empty() ? "" : ",", more);
}

std::string boxOfHeight(double height, double z = 0) {
  return mesh("box", 6, 2, z, fmt::format("'scale':[1,1,{}]", height));
}

/// From the box of 1 m around `center`, turned by `angle`; negative inside.
double distanceToBox(Vec2 center, double angle, Vec2 p) {
  const double radians = angle * std::numbers::pi / 180;
  const Vec2 along{std::cos(radians), std::sin(radians)};
  const double x = std::abs(dot(p - center, along)) - 0.5;
  const double y = std::abs(dot(p - center, turned90(along))) - 0.5;
  return x > 0 && y > 0 ? std::hypot(x, y) : std::max(x, y);
}

TEST(MeshBody, StopsAWalkerWhoRunsStraightIntoIt) {
  const LoadedLevel hall = hallWith(mesh("box", 6, 2));
  const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 5.5 - kRadius, 1e-4);
  EXPECT_EQ(walker.feet.y, 2);
  EXPECT_EQ(walker.feet.z, 0);
}

TEST(MeshBody, LetsAWalkerSlideAlongASideAndOn) {
  const LoadedLevel hall = hallWith(mesh("box", 6, 2, 0, "'angle':30"));
  Walker walker = standing(hall.scene(), "hall", {2, 2.1, 0});
  const Vec2 side{std::cos(std::numbers::pi * 2 / 3), std::sin(std::numbers::pi * 2 / 3)};
  int ticksBeside = 0;
  for (int i = 0; i < 400; ++i) {
    const Walker before = walker;
    walker = walked(hall.scene(), walker, kForward);
    const double distance = distanceToBox({6, 2}, 30, walker.feet.xy());
    EXPECT_GE(distance, kRadius - 1e-9);
    const double along = dot(walker.feet.xy() - Vec2{6, 2}, side);
    if (distance > kRadius + 2 * kSkin || std::abs(along) > 0.45) continue;
    const Vec2 moved = walker.feet.xy() - before.feet.xy();
    if (distanceToBox({6, 2}, 30, before.feet.xy()) > kRadius + 2 * kSkin) continue;
    EXPECT_NEAR(cross(moved, side), 0, 1e-12);
    ++ticksBeside;
  }
  EXPECT_GT(ticksBeside, 10);
  EXPECT_NEAR(walker.feet.x, 12 - kRadius, 1e-4);
}

TEST(MeshBody, IsRoundedAtItsCornersByTheRadius) {
  const LoadedLevel hall = hallWith(mesh("box", 6, 2));
  Walker walker = standing(hall.scene(), "hall", {5.1, 1.7, 0}, 45);
  double nearest = kInfinity;  // to the corner, of places before it
  for (int i = 0; i < 128; ++i) {
    walker = walked(hall.scene(), walker, kForward);
    const Vec2 p = walker.feet.xy();
    EXPECT_GE(distanceToBox({6, 2}, 0, p), kRadius - 1e-9);
    if (p.x < 5.4 && p.y > 2.6) nearest = std::min(nearest, length(p - Vec2{5.5, 2.5}));
  }
  EXPECT_NEAR(nearest, kRadius, 2e-3);
}

TEST(MeshBody, OfNoMoreThanAStepIsSteppedOnAndOff) {
  for (const double height : {0.4, 0.41}) {
    const LoadedLevel hall = hallWith(boxOfHeight(height));
    Walker walker = standing(hall.scene(), "hall", {4.5, 2, 0});
    double highest = 0;
    for (int i = 0; i < 256; ++i) {
      walker = walked(hall.scene(), walker, kForward);
      highest = std::max(highest, walker.feet.z);
      EXPECT_TRUE(walker.isOnGround) << i;
    }
    EXPECT_EQ(highest, height == 0.4 ? 0.4 : 0);
    EXPECT_EQ(walker.feet.z, 0);
    EXPECT_NEAR(walker.feet.x, height == 0.4 ? 11.7 : 5.2, 1e-4);
  }
}

TEST(MeshBody, BearsAWalkerUntilNothingOfTheFeetIsOnIt) {
  const LoadedLevel hall = hallWith(mesh("box", 6, 2));
  Walker walker = walkerAt(hall.scene(), SectorId(0), {6.2, 2, 3.5}, 0, 0);
  walker = after(hall.scene(), walker, {}, 128);
  EXPECT_EQ(walker.feet.z, 1);
  EXPECT_TRUE(walker.isOnGround);
  while (walker.feet.z == 1) {
    EXPECT_LT(walker.feet.x, 6.5 + kRadius + 0.05);
    EXPECT_TRUE(walker.isOnGround);
    walker = walked(hall.scene(), walker, kForward);
  }
  EXPECT_GE(walker.feet.x, 6.5 + kRadius);
  EXPECT_FALSE(walker.isOnGround);
  EXPECT_EQ(after(hall.scene(), walker, kForward, 64).feet.z, 0);
}

TEST(MeshBody, IsJumpedOntoWhereItIsAJumpAndAStepHigh) {
  for (const double height : {0.9, 1.0}) {
    const LoadedLevel hall = hallWith(boxOfHeight(height));
    Walker walker = standing(hall.scene(), "hall", {3, 2, 0});
    WalkInput input = kForward;
    input.jump = true;
    bool stood = false;
    for (int i = 0; i < 320; ++i) {
      walker = walked(hall.scene(), walker, input);
      stood = stood || (walker.isOnGround && walker.feet.z == height);
    }
    EXPECT_EQ(stood, height == 0.9);
  }
}

TEST(MeshBody, ThatHangsHighEnoughIsPassedBelow) {
  for (const double z : {1.8, 1.75}) {
    const LoadedLevel hall = hallWith(boxOfHeight(0.5, z));
    const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
    EXPECT_NEAR(walker.feet.x, z == 1.8 ? 11.7 : 5.2, 1e-4);
  }
}

TEST(MeshBody, ThatHangsIsPassedBelowByCrouchingAndHoldsTheHeadDown) {
  const LoadedLevel hall = hallWith(boxOfHeight(0.5, 1));
  Walker walker = standing(hall.scene(), "hall", {4, 2, 0});
  WalkInput crouched = kForward;
  crouched.crouch = true;
  while (walker.feet.x < 6) walker = walked(hall.scene(), walker, crouched);
  walker = after(hall.scene(), walker, {}, 64);
  EXPECT_LE(bodyOf(hall.level, walker.crouch).height, 1 + 1e-6);
  EXPECT_GT(walker.crouch, 0);
  walker = after(hall.scene(), walker, kForward, 400);
  EXPECT_NEAR(walker.feet.x, 11.7, 1e-4);
  EXPECT_EQ(walker.crouch, 0);
}

TEST(MeshBody, StopsAJumpFromBelow) {
  const LoadedLevel hall = hallWith(boxOfHeight(0.5, 2));
  Walker walker = standing(hall.scene(), "hall", {6, 2, 0});
  WalkInput jump;
  jump.jump = true;
  double highest = 0;
  for (int i = 0; i < 128; ++i) {
    walker = walked(hall.scene(), walker, jump);
    highest = std::max(highest, walker.feet.z);
  }
  EXPECT_NEAR(highest, 0.2, 1e-9);
}

TEST(MeshBody, WithoutThicknessStopsFromBothSides) {
  for (const char* const model : {"panel", "cut_panel"}) {
    const LoadedLevel hall = hallWith(mesh(model, 6, 2));
    const Scene scene = hall.scene();
    EXPECT_NEAR(after(scene, standing(scene, "hall", {2, 2.2, 0}), kRun, 192).feet.x, 6 - kRadius,
                1e-4);
    EXPECT_NEAR(after(scene, standing(scene, "hall", {10, 2.2, 0}, 180), kRun, 192).feet.x,
                6 + kRadius, 1e-4);
  }
}

TEST(MeshBody, WithoutThicknessStopsBeforeItsEnds) {
  for (const char* const model : {"panel", "cut_panel"})
    for (int angle = 0; angle < 360; angle += 7) {
      const LoadedLevel hall = hallWith(mesh(model, 6, 2, 0, fmt::format("'angle':{}", angle)));
      const double radians = (angle + 90) * std::numbers::pi / 180;
      const Vec2 along{std::cos(radians), std::sin(radians)};
      const Vec2 start = Vec2{6, 2} - 1.2 * along;
      const Walker walker =
          after(hall.scene(), standing(hall.scene(), "hall", {start.x, start.y, 0}, angle + 90),
                kForward, 32);
      EXPECT_NEAR(dot(walker.feet.xy() - Vec2{6, 2}, along), -0.5 - kRadius, 1e-4)
          << model << ", " << angle << " degrees";
    }
}

TEST(MeshBody, ThatIsNotSolidStopsNobody) {
  const LoadedLevel hall = hallWith(mesh("box", 6, 2, 0, "'solid':false"));
  EXPECT_TRUE(hall.level.bodies.empty());
  const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 11.7, 1e-4);
}

TEST(MeshBody, IsTheConvexHullOfItsPlanBetweenItsLowestAndHighestPoint) {
  // Two legs, 2 m apart and of different heights.
  const std::string legs =
      "v 0 0 -1\nv 0.1 0 -1\nv 0 2 -1\nv 0 0 1\nv 0.1 0 1\nv 0 1 1\n"
      "f 1 2 3\nf 4 5 6\n";
  const LoadedLevel hall = test::hallWith(mesh("legs", 6, 2), 4, {{"legs.obj", legs}});
  const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 6 - kRadius, 1e-4);
  Walker above = walkerAt(hall.scene(), SectorId(0), {6, 2.8, 3.8}, 0, 0);
  above = after(hall.scene(), above, {}, 64);
  EXPECT_EQ(above.feet.z, 2);
}

/// A round body of many edges stops as a cylinder does.
TEST(MeshBody, OfAThousandCornersIsWalkedRoundLikeACylinder) {
  const LoadedLevel many = hallWith(mesh("gon", 6, 2, 0, "'scale':0.5"));
  const LoadedLevel round =
      hallWith("{'sprite':'#c04020','x':6,'y':2,'z':0,'radius':0.5,'height':0.5}");
  Walker a = standing(many.scene(), "hall", {2, 2.05, 0});
  Walker b = standing(round.scene(), "hall", {2, 2.05, 0});
  for (int i = 0; i < 400; ++i) {
    a = walked(many.scene(), a, kRun);
    b = walked(round.scene(), b, kRun);
    EXPECT_GE(length(a.feet.xy() - Vec2{6, 2}), 0.8 - 1e-5);
    EXPECT_NEAR(a.feet.x, b.feet.x, 0.01) << i;
    EXPECT_NEAR(a.feet.y, b.feet.y, 0.01) << i;
  }
  EXPECT_NEAR(a.feet.x, 11.7, 1e-4);
  EXPECT_GT(a.feet.y, 2.7);
}

TEST(MeshBody, LetsAWalkerOutWhoStartsInIt) {
  for (const char* const model : {"box", "panel", "cut_panel", "triangle", "gon"}) {
    const LoadedLevel hall = hallWith(mesh(model, 6, 2, 0, "'scale':[1,1,3]"));
    for (const double y : {2.0, 2.45, 1.5})
      for (int angle = 0; angle < 360; angle += 30) {
        const Walker start = walkerAt(hall.scene(), SectorId(0), {6, y, 1.6}, angle, 0);
        ASSERT_EQ(start.feet.z, 0);
        const Walker walker = after(hall.scene(), start, kForward, 32);
        EXPECT_GT(length(walker.feet.xy() - start.feet.xy()), 0.4)
            << model << " at y " << y << ", " << angle << " degrees";
      }
  }
}

TEST(MeshBody, AroundAWholeRoomLeavesItFree) {
  const LoadedLevel hall = hallWith(mesh("box", 6, 2, 0, "'scale':30"));
  const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 11.7, 1e-4);
}

TEST(MeshBody, DoesNotPushAWalkerIntoAWall) {
  const LoadedLevel hall = hallWith(mesh("triangle", 6, 1.2, 0, "'angle':17") + "," +
                                    mesh("box", 7.5, 1, 0, "'angle':40"));
  for (const double angle : {0, -20, -45, 20, 60}) {
    Walker walker = standing(hall.scene(), "hall", {4, 0.5, 0}, angle);
    for (int i = 0; i < 300; ++i) {
      walker = walked(hall.scene(), walker, kRun);
      EXPECT_GE(walker.feet.y, kRadius - 1e-9);
      EXPECT_GE(distanceToBox({7.5, 1}, 40, walker.feet.xy()), kRadius - 1e-9);
    }
  }
}

TEST(MeshBody, ReachesThroughAnOpeningIntoTheNextRoom) {
  const LoadedLevel rooms = roomsWith(mesh("box", 4.1, 2), "{'next':'east'}", "{'next':'west'}");
  ASSERT_EQ(rooms.level.meshes[0].sector, SectorId(1));
  ASSERT_EQ(rooms.level.bodiesBySector.size(), 2U);
  const Walker walker = after(rooms.scene(), standing(rooms.scene(), "west", {1, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 4.1 - 0.5 - kRadius, 1e-4);
}

TEST(MeshBody, DoesNotReachThroughAWall) {
  const LoadedLevel rooms = roomsWith(mesh("box", 4.1, 2), kSolid, kSolid);
  ASSERT_EQ(rooms.level.bodiesBySector.size(), 1U);
  const Walker walker = after(rooms.scene(), standing(rooms.scene(), "west", {1, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 3.7, 1e-4);
}

TEST(MeshBody, ReachesThroughAWindowOnlyWhereItIsAsHighAsTheSill) {
  for (const double height : {1.0, 1.5}) {
    const LoadedLevel rooms =
        roomsWith(mesh("box", 4.1, 2, 0, fmt::format("'scale':[1,1,{}]", height)),
                  test::windowTo("east"), test::windowTo("west"));
    const Walker walker =
        after(rooms.scene(), standing(rooms.scene(), "west", {1, 2, 0}), kRun, 192);
    EXPECT_NEAR(walker.feet.x, height == 1.0 ? 3.7 : 3.3, 1e-4);
  }
}

TEST(MeshBody, ReachesThroughTheFloorsThatItStandsIn) {
  const LoadedLevel storeys =
      test::storeysWith(mesh("box", 5, 2, 0, "'scale':[1,1,6]"), {{"box.obj", kBox}});
  ASSERT_EQ(storeys.level.bodiesBySector.size(), 2U);
  Walker walker = walkerAt(storeys.scene(), SectorId(0), {2, 2, 6}, 0, 0);
  walker.isFlying = true;
  walker = after(storeys.scene(), walker, kForward, 192);
  EXPECT_EQ(storeys.level[walker.sector].name, "up");
  EXPECT_NEAR(walker.feet.x, 4.5 - kRadius, 1e-4);
}

TEST(MeshBody, ThatLiesOverAPitFromItsEdgeBearsAWalkerAcross) {
  const std::vector<test::NamedText> models{{"plank.obj", kPlank}};
  const LoadedLevel pit = test::levelFrom(
      "{'light':1,'things':[" + mesh("plank", 3.8, 2, 0, "'scale':[4.4,1,1]") + "],'sectors':{" +
          test::sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 4,
                           "[" + kSolid + ",{'next':'pit'}," + kSolid + "," + kSolid + "]") +
          "," +
          test::sectorText("pit", "4,0, 8,0, 8,4, 4,4", -3, 4,
                           "[" + kSolid + ",{'next':'east','texture':'#808080'}," + kSolid +
                               ",{'next':'west','texture':'#808080'}]") +
          "," +
          test::sectorText("east", "8,0, 12,0, 12,4, 8,4", 0, 4,
                           "[" + kSolid + "," + kSolid + "," + kSolid + ",{'next':'pit'}]") +
          "}}",
      "[]", models);
  Walker walker = standing(pit.scene(), "west", {1, 2, 0});
  for (int i = 0; i < 192; ++i) {
    walker = walked(pit.scene(), walker, kRun);
    EXPECT_EQ(walker.feet.z, 0) << walker.feet.x;
  }
  EXPECT_EQ(pit.level[walker.sector].name, "east");
}

TEST(MeshBody, FarAwayChangesNoBitOfAWalk) {
  const LoadedLevel empty = hallWith("");
  const LoadedLevel far = hallWith(mesh("gon", 11.5, 3.5, 0, "'scale':0.2"));
  Walker a = standing(empty.scene(), "hall", {2, 2, 0});
  Walker b = standing(far.scene(), "hall", {2, 2, 0});
  for (int i = 0; i < 256; ++i) {
    const WalkInput input{.forward = 127, .turn = 2000 + 13 * i, .jump = i % 50 == 0};
    a = walked(empty.scene(), a, input);
    b = walked(far.scene(), b, input);
    ASSERT_EQ(a, b) << i;
  }
}

}  // namespace
}  // namespace hearth
