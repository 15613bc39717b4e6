#include "walk/moving_level.h"

#include <fmt/format.h>

#include <algorithm>

#include "random_levels/random.h"
#include "walk/body.h"
#include "walks.h"

namespace hearth {
namespace {

using test::kForward;
using test::kSolid;
using test::sectorText;
using test::standing;

/// A hall, a door to the east that opens to 3 m, a yard behind it; and to the west a lift that goes
/// from the hall's floor up to a gallery at 2 m.
LoadedLevel castle(std::string_view movers, std::string_view wallOfHall = "") {
  const auto to = [](std::string_view next, std::string_view more = "") {
    return fmt::format("{{'next':'{}','texture':'#604020'{}}}", next, more);
  };
  const std::string south =
      wallOfHall.empty() ? kSolid : fmt::format("{{'texture':'#808080',{}}}", wallOfHall);
  return test::levelFrom(
      fmt::format("{{'light':1,'movers':{{{}}},'sectors':{{", movers) +
      sectorText("hall", "0,0, 10,0, 10,4, 0,4", 0, 6,
                 "[" + kSolid + "," + to("door") + "," + south + "," + to("lift") + "]") +
      "," +
      sectorText("door", "10,0, 10.5,0, 10.5,4, 10,4", 0, 0,
                 "[" + kSolid + "," + to("yard", ",'cross':'far'") + "," + kSolid + "," +
                     to("hall") + "]") +
      "," +
      sectorText("yard", "10.5,0, 20,0, 20,4, 10.5,4", 0, 6,
                 "[" + kSolid + "," + kSolid + "," + kSolid + "," + to("door") + "]") +
      "," +
      sectorText("lift", "-3,0, 0,0, 0,4, -3,4", 0, 6,
                 "[" + kSolid + "," + to("hall") + "," + kSolid + "," + to("gallery") + "]") +
      "," +
      sectorText("gallery", "-6,0, -3,0, -3,4, -6,4", 2, 6,
                 "[" + kSolid + "," + to("lift") + "," + kSolid + "," + kSolid + "]") +
      "}}");
}

const std::string kGate =
    "'gate':{'sectors':'door','part':'ceiling','to':3,'speed':3,'wait':1,'trigger':'use'},";
const std::string kLift =
    "'lift':{'sectors':'lift','part':'floor','to':2,'speed':1,'trigger':'enter','zones':'lift'},";
/// At the far end of nothing: it shows what crossing the door does.
const std::string kFar = "'far':{'sectors':'gallery','part':'ceiling','to':5,'speed':1}";

class MovingCastle : public testing::Test {
 protected:
  explicit MovingCastle(std::string_view wallOfHall = "")
      : loaded_(castle(kGate + kLift + kFar, wallOfHall)), level(loaded_.scene()) {}

  enum Movers { Gate, Lift, Far };

  void stand(const std::string& sector, Vec3 feet, double angle) {
    walker = standing(level.scene(), sector, feet, angle);
  }
  void tick(const WalkInput& input, int ticks = 1) {
    for (int i = 0; i < ticks; ++i) walker = level.ticked(walker, input);
  }
  double share(Movers mover) const { return level.movers()[mover].share; }
  const std::string& sector() const { return level.level()[walker.sector].name; }

 private:
  LoadedLevel loaded_;

 protected:
  MovingLevel level;
  Walker walker;
};

TEST_F(MovingCastle, OpensADoorAheadByTheUseKey) {
  stand("hall", {9, 2, 0}, 0);
  tick({.use = true});
  tick({}, 64);
  EXPECT_EQ(share(Gate), 1);
  EXPECT_EQ(level.scene().zCeiling(level.level().sectors[1]), 3);
  tick(kForward, 100);
  EXPECT_EQ(sector(), "yard");
}

TEST_F(MovingCastle, OpensNoDoorThatIsFarOrNotAhead) {
  stand("hall", {8, 2, 0}, 0);
  tick({.use = true}, 10);
  stand("hall", {9, 2, 0}, 180);
  tick({.use = true}, 10);
  stand("hall", {9, 2, 0}, 90);
  tick({.use = true}, 10);
  EXPECT_EQ(share(Gate), 0);
}

TEST_F(MovingCastle, KeepsOutOfAShutDoor) {
  stand("hall", {9, 2, 0}, 0);
  tick(kForward, 200);
  EXPECT_EQ(sector(), "hall");
  EXPECT_LT(walker.feet.x, 10 - 0.3 + 1e-5);
}

TEST_F(MovingCastle, GoesOnFromAnEarlierTickWithItsMovers) {
  stand("hall", {9, 2, 0}, 0);
  tick({.use = true});
  tick({}, 16);
  const Walker earlier = walker;
  const std::vector<MoverState> movers(level.movers().begin(), level.movers().end());
  tick(kForward, 64);
  const Walker later = walker;

  level.setMovers(movers);
  walker = earlier;
  EXPECT_TRUE(std::ranges::equal(level.movers(), movers));
  EXPECT_LT(level.shares()[Gate], 1);
  tick(kForward, 64);
  EXPECT_EQ(walker, later);
  EXPECT_EQ(level.shares()[Gate], 1);
}

TEST_F(MovingCastle, ShutsADoorAfterItsWait) {
  stand("hall", {9, 2, 0}, 0);
  tick({.use = true});
  tick({}, 63 + 64 + 32);
  EXPECT_LT(share(Gate), 1);
  tick({}, 64);
  EXPECT_EQ(share(Gate), 0);
}

TEST_F(MovingCastle, TurnsADoorBackThatWouldCrushTheWalker) {
  stand("hall", {9, 2, 0}, 0);
  tick({.use = true});
  tick(kForward, 50);  // into the doorway
  ASSERT_NEAR(walker.feet.x, 10.2, 0.4);
  double least = 1;
  for (int i = 0; i < 640; ++i) {
    tick({});
    least = std::min(least, share(Gate));
    const double top = level.scene().zCeiling(level.level().sectors[1]);
    ASSERT_GE(top, 1.8 - 1e-5) << "the walker is 1.8 m high";
  }
  EXPECT_LT(least, 0.7) << "it has come down to the head";
}

/// The axis of the body is in the hall, its side in the doorway.
TEST_F(MovingCastle, TurnsADoorBackThatWouldCrushTheWalkersSide) {
  stand("hall", {9, 2, 0}, 0);
  tick({.use = true});
  tick({}, 30);
  while (walker.feet.x < 9.8) tick({.forward = 60});
  double least = 1;
  for (int i = 0; i < 640; ++i) {
    tick({});
    ASSERT_EQ(sector(), "hall");
    least = std::min(least, share(Gate));
    ASSERT_GE(level.scene().zCeiling(level.level().sectors[1]), 1.8 - 1e-5);
  }
  EXPECT_LT(least, 0.7) << "it has come down to the head";
}

TEST_F(MovingCastle, RestsWhereAHandHasPushedIt) {
  stand("hall", {5, 2, 0}, 0);
  walker = level.pushed(walker, {Gate, 0.5});
  EXPECT_EQ(share(Gate), 0.5);
  tick({}, 640);
  EXPECT_EQ(share(Gate), 0.5);
  EXPECT_EQ(level.scene().zCeiling(level.level().sectors[1]), 1.5);
}

TEST_F(MovingCastle, IsNotPushedOntoTheWalkersHead) {
  stand("hall", {9, 2, 0}, 0);
  tick({.use = true});
  tick(kForward, 50);  // into the doorway
  const Walker before = walker;
  walker = level.pushed(walker, {Gate, 0});
  EXPECT_EQ(walker, before);
  const double top = level.scene().zCeiling(level.level().sectors[1]);
  EXPECT_GE(top, 1.8 - 1e-5) << "the walker is 1.8 m high";
  EXPECT_LT(top, 1.8 + 0.05) << "and no farther from it than a step";
}

TEST_F(MovingCastle, TakesTheWalkerAlongWhenItIsPushed) {
  stand("lift", {-1, 2, 0}, 0);
  walker = level.pushed(walker, {Lift, 0.75});
  EXPECT_EQ(walker.feet.z, 1.5);
  walker = level.pushed(walker, {Lift, 0.25});
  EXPECT_EQ(walker.feet.z, 0.5);
}

TEST_F(MovingCastle, LiftsNobodyWhoStandsBesideWhatIsPushed) {
  stand("hall", {0.4, 2, 0}, 0);
  const Walker before = walker;
  walker = level.pushed(walker, {Lift, 1});
  EXPECT_EQ(share(Lift), 1);
  EXPECT_EQ(walker, before);
}

TEST_F(MovingCastle, StartsWhatIsCrossedFromTheFront) {
  stand("hall", {9, 2, 0}, 0);
  tick({.use = true});
  tick(kForward, 20);
  EXPECT_EQ(level.movers()[Far].direction, 0);
  tick(kForward, 60);
  ASSERT_EQ(sector(), "yard");
  EXPECT_GT(share(Far), 0);
}

TEST_F(MovingCastle, CarriesTheWalkerUpSmoothlyAndLetsItOff) {
  stand("hall", {1, 2, 0}, 180);
  while (walker.sector != SectorId(3)) tick(kForward);
  double z = walker.feet.z;
  for (int i = 0; i < 3 * 64 && share(Lift) < 1; ++i) {
    tick({});
    EXPECT_LE(walker.feet.z - z, 1.0 / 64 + 1e-12) << i;
    EXPECT_GE(walker.feet.z, z);
    EXPECT_TRUE(walker.isOnGround);
    EXPECT_EQ(walker.feet.z, level.scene().zFloor(level.level().sectors[3]));
    z = walker.feet.z;
  }
  EXPECT_EQ(walker.feet.z, 2);
  tick(kForward, 128);
  EXPECT_EQ(sector(), "gallery");
}

class MovingCastleWithASwitch : public MovingCastle {
 protected:
  MovingCastleWithASwitch() : MovingCastle("'use':['gate','far']") {}
};

TEST_F(MovingCastleWithASwitch, StartsAllThatAWallNames) {
  stand("hall", {5, 3, 0}, 90);
  tick({.use = true});
  tick({}, 2);
  EXPECT_GT(share(Gate), 0);
  EXPECT_GT(share(Far), 0);
  EXPECT_EQ(share(Lift), 0);
}

TEST(MovingLifts, LowerTheWalkerWithoutAFall) {
  const LoadedLevel loaded = castle(
      "'far':{'sectors':'gallery','part':'floor','to':0,'speed':4,'trigger':'loop','wait':0.5}");
  MovingLevel level(loaded.scene());
  Walker walker = standing(level.scene(), "gallery", {-4.5, 2, 2});
  for (int i = 0; i < 300; ++i) {
    walker = level.ticked(walker, {});
    EXPECT_TRUE(walker.isOnGround) << i;
    EXPECT_EQ(walker.feet.z, level.scene().zFloor(level.level().sectors[4])) << i;
  }
}

TEST(MovingLevels, AreTheSameForTheSameInputsToTheBit) {
  const LoadedLevel loaded = castle(kGate + kLift + kFar);
  MovingLevel one(loaded.scene());
  MovingLevel other(loaded.scene());
  Walker a = standing(one.scene(), "hall", {9, 2, 0});
  Walker b = a;
  random_levels::Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const WalkInput input{.forward = static_cast<int>(random.between(-127, 127)),
                          .turn = static_cast<int>(random.between(-4000, 4000)),
                          .use = random.chance(0.2)};
    a = one.ticked(a, input);
    b = other.ticked(b, input);
    ASSERT_EQ(a, b);
    ASSERT_TRUE(std::ranges::equal(one.movers(), other.movers()));
  }
}

/// Whoever walks about where everything moves is never out of the air, nor pressed flat.
TEST(MovingLevels, LeaveTheWalkerItsRoom) {
  const LoadedLevel loaded = castle(
      "'gate':{'sectors':'door','part':'ceiling','to':3,'speed':4,'trigger':'loop'},"
      "'lift':{'sectors':'lift','part':'floor','to':5.5,'speed':2,'trigger':'loop','wait':0.2},"
      "'press':{'sectors':['hall','yard'],'part':'ceiling','to':0.5,'speed':1,'trigger':'loop'},"
      "'far':{'sectors':'gallery','part':'floor','to':4,'speed':3,'trigger':'loop'}");
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    MovingLevel level(loaded.scene());
    Walker walker = standing(level.scene(), "hall", {5, 2, 0});
    random_levels::Random random(seed);
    WalkInput input;
    for (int i = 0; i < 4000; ++i) {
      if (random.chance(0.05))
        input = {.forward = random.chance(0.7) ? 127 : 0,
                 .turn = static_cast<int>(random.between(-3000, 3000)),
                 .run = random.chance(0.5),
                 .jump = random.chance(0.1),
                 .crouch = random.chance(0.1)};
      walker = level.ticked(walker, input);
      const Sector& sector = level.level()[walker.sector];
      ASSERT_TRUE(contains(level.scene(), sector, walker.feet, kPositionSlack)) << i;
      const double height = bodyOf(level.level(), walker.crouch).height;
      ASSERT_GE(level.scene().zCeiling(sector) - walker.feet.z, height - 2 * kSkin) << i;
    }
  }
}

}  // namespace
}  // namespace hearth
