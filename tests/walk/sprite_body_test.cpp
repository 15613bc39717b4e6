#include <fmt/format.h>
#include <gtest/gtest.h>

#include "halls.h"
#include "walk/body.h"

/// Sprites with a body are solid to the player, whose own body has a radius of 0.3 m, a height of
/// 1.8 m and a step of 0.4 m.
namespace hearth {
namespace {

using test::after;
using test::hallWith;
using test::kForward;
using test::kRun;
using test::kSolid;
using test::roomsWith;
using test::standing;

/// Round, at (x, y), from `z` up.
std::string body(double x, double y, double z, double radius, double height) {
  return fmt::format("{{'sprite':'#c04020','x':{},'y':{},'z':{},'radius':{},'height':{}}}", x, y, z,
                     radius, height);
}

double distanceTo(const Sprite& sprite, const Walker& walker) {
  return length(sprite.position.xy() - walker.feet.xy());
}

TEST(SpriteBody, StopsAWalkerWhoRunsStraightIntoIt) {
  const LoadedLevel hall = hallWith(body(6, 2, 0, 0.5, 1));
  const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 6 - 0.5 - 0.3, 1e-4);
  EXPECT_EQ(walker.feet.y, 2);
  EXPECT_EQ(walker.feet.z, 0);
}

TEST(SpriteBody, LetsAWalkerSlideRoundIt) {
  const LoadedLevel hall = hallWith(body(6, 2, 0, 0.5, 1));
  Walker walker = standing(hall.scene(), "hall", {2, 2.05, 0});
  for (int i = 0; i < 400; ++i) {
    walker = walked(hall.scene(), walker, kRun);
    EXPECT_GE(distanceTo(hall.level.sprites[0], walker), 0.8 - 1e-9);
  }
  EXPECT_NEAR(walker.feet.x, 12 - 0.3, 1e-4);
  EXPECT_GT(walker.feet.y, 2.7);
}

TEST(SpriteBody, OfNoMoreThanAStepIsSteppedOnAndOff) {
  for (const double height : {0.4, 0.41}) {
    const LoadedLevel hall = hallWith(body(6, 2, 0, 0.5, height));
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

TEST(SpriteBody, BearsAWalkerWhoFallsOnIt) {
  const LoadedLevel hall = hallWith(body(6, 2, 0, 0.5, 1));
  Walker walker = walkerAt(hall.scene(), SectorId(0), {6.2, 2, 3.5}, 0, 0);
  walker = after(hall.scene(), walker, {}, 128);
  EXPECT_EQ(walker.feet.z, 1);
  EXPECT_TRUE(walker.isOnGround);
  walker = after(hall.scene(), walker, kForward, 128);
  EXPECT_EQ(walker.feet.z, 0);
}

TEST(SpriteBody, IsJumpedOntoWhereItIsAJumpAndAStepHigh) {
  for (const double height : {0.9, 1.0}) {
    const LoadedLevel hall = hallWith(body(6, 2, 0, 0.5, height));
    Walker walker = standing(hall.scene(), "hall", {3, 2, 0});
    WalkInput input = kForward;
    input.jump = true;
    double highest = 0;
    bool stood = false;
    for (int i = 0; i < 320; ++i) {
      walker = walked(hall.scene(), walker, input);
      stood = stood || (walker.isOnGround && walker.feet.z == height);
    }
    EXPECT_EQ(stood, height == 0.9) << highest;
  }
}

TEST(SpriteBody, ThatHangsHighEnoughIsPassedBelow) {
  for (const double z : {1.8, 1.75}) {
    const LoadedLevel hall = hallWith(body(6, 2, z, 0.5, 0.5));
    Walker walker = standing(hall.scene(), "hall", {2, 2, 0});
    walker = after(hall.scene(), walker, kRun, 192);
    EXPECT_NEAR(walker.feet.x, z == 1.8 ? 11.7 : 5.2, 1e-4);
  }
}

TEST(SpriteBody, ThatHangsIsPassedBelowByCrouchingAndHoldsTheHeadDown) {
  const LoadedLevel hall = hallWith(body(6, 2, 1, 1, 0.5));
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

TEST(SpriteBody, StopsAJumpFromBelow) {
  const LoadedLevel hall = hallWith(body(6, 2, 2, 1, 0.5));
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

TEST(SpriteBody, IsNotSteppedOnWhereThereIsNoRoomAboveIt) {
  const LoadedLevel hall = hallWith(body(6, 2, 0, 0.5, 0.3), 2);
  const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
  EXPECT_EQ(walker.feet.z, 0);
  EXPECT_NEAR(walker.feet.x, 5.2, 1e-4);
}

TEST(SpriteBody, AndAnotherOneLeaveNoWayBetweenThatIsTooNarrow) {
  for (const double gap : {0.62, 0.58}) {
    const double y = 0.5 + gap / 2;
    const LoadedLevel hall = hallWith(body(6, 2 - y, 0, 0.5, 1) + "," + body(6, 2 + y, 0, 0.5, 1));
    Walker walker = standing(hall.scene(), "hall", {3, 2.1, 0});
    for (int i = 0; i < 400; ++i) {
      walker = walked(hall.scene(), walker, kRun);
      for (const Sprite& sprite : hall.level.sprites)
        EXPECT_GE(distanceTo(sprite, walker), 0.8 - 1e-9);
    }
    EXPECT_EQ(walker.feet.x > 7, gap > 0.6) << walker.feet.x;
  }
}

TEST(SpriteBody, DoesNotPushAWalkerIntoAWall) {
  // Between the wall and the bodies the way narrows until the walker is stuck.
  const LoadedLevel hall = hallWith(body(6, 1, 0, 0.5, 1) + "," + body(7, 0.9, 0, 0.5, 1) + "," +
                                    body(8, 0.8, 0, 0.5, 1));
  for (const double angle : {0, -20, -45, 20, 60}) {
    Walker walker = standing(hall.scene(), "hall", {4, 0.5, 0}, angle);
    for (int i = 0; i < 300; ++i) {
      walker = walked(hall.scene(), walker, kRun);
      EXPECT_GE(walker.feet.y, 0.3 - 1e-9);
      for (const Sprite& sprite : hall.level.sprites)
        EXPECT_GE(distanceTo(sprite, walker), 0.8 - 1e-9);
    }
  }
}

TEST(SpriteBody, LetsAWalkerOutWhoStartsInIt) {
  const LoadedLevel hall = hallWith(body(6, 2, 0, 1, 3));
  Walker walker = walkerAt(hall.scene(), SectorId(0), {6.3, 2, 1.6}, 0, 0);
  walker = after(hall.scene(), walker, kForward, 256);
  EXPECT_NEAR(walker.feet.x, 11.7, 1e-4);
}

TEST(SpriteBody, ReachesThroughAnOpeningIntoTheNextRoom) {
  const LoadedLevel rooms =
      roomsWith(body(4.1, 2, 0, 0.8, 1), "{'next':'east'}", "{'next':'west'}");
  ASSERT_EQ(rooms.level.sprites[0].sector, SectorId(1));
  ASSERT_EQ(rooms.level.bodiesBySector.size(), 2U);
  const Walker walker = after(rooms.scene(), standing(rooms.scene(), "west", {1, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 4.1 - 0.8 - 0.3, 1e-4);
}

TEST(SpriteBody, DoesNotReachThroughAWall) {
  const LoadedLevel rooms = roomsWith(body(4.1, 2, 0, 0.8, 1), kSolid, kSolid);
  ASSERT_EQ(rooms.level.bodiesBySector.size(), 1U);
  const Walker walker = after(rooms.scene(), standing(rooms.scene(), "west", {1, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 3.7, 1e-4);
}

TEST(SpriteBody, ReachesThroughAWindowOnlyWhereItIsAsHighAsTheSill) {
  for (const double height : {1.0, 1.5}) {
    const LoadedLevel rooms =
        roomsWith(body(4.1, 2, 0, 0.8, height), test::windowTo("east"), test::windowTo("west"));
    const Walker walker =
        after(rooms.scene(), standing(rooms.scene(), "west", {1, 2, 0}), kRun, 192);
    EXPECT_NEAR(walker.feet.x, height == 1.0 ? 3.7 : 3.0, 1e-4);
  }
}

TEST(SpriteBody, ReachesThroughTheFloorsThatItStandsIn) {
  const LoadedLevel storeys = test::storeysWith(body(5, 2, 0, 0.5, 6));
  ASSERT_EQ(storeys.level.bodiesBySector.size(), 2U);
  Walker walker = walkerAt(storeys.scene(), SectorId(0), {2, 2, 6}, 0, 0);
  walker.isFlying = true;
  walker = after(storeys.scene(), walker, kForward, 192);
  EXPECT_EQ(storeys.level[walker.sector].name, "up");
  EXPECT_NEAR(walker.feet.x, 5 - 0.8, 1e-4);
}

TEST(SpriteBody, ThatIsNotGivenStopsNobody) {
  const LoadedLevel hall = hallWith("{'sprite':'#c04020','x':6,'y':2,'size':[1,1]}");
  EXPECT_TRUE(hall.level.bodies.empty());
  const Walker walker = after(hall.scene(), standing(hall.scene(), "hall", {2, 2, 0}), kRun, 192);
  EXPECT_NEAR(walker.feet.x, 11.7, 1e-4);
}

TEST(SpriteBody, FarAwayChangesNoBitOfAWalk) {
  const LoadedLevel empty = hallWith("");
  const LoadedLevel far = hallWith(body(11, 3.5, 0, 0.2, 1));
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
