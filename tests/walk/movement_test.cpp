#include <fmt/format.h>

#include <cmath>

#include "walk/walk_clock.h"
#include "walks.h"

namespace hearth {
namespace {

using test::after;
using test::kForward;
using test::kRun;
using test::sectorText;
using test::standing;

LoadedLevel hall() {
  return test::levelFrom("{'light':1,'sectors':{" +
                         sectorText("hall", "0,0, 100,0, 100,100, 0,100", 0, 50) + "}}");
}

class InAHall : public testing::Test {
 protected:
  LoadedLevel loaded_ = hall();
  const Scene scene = loaded_.scene();
  Walker start = standing(scene, "hall", {50, 50, 0});
};

TEST_F(InAHall, WalksAt2AndAHalfMetresASecondAndRunsAt5) {
  for (const bool run : {false, true}) {
    const double speed = run ? 5 : 2.5;
    const WalkInput input{.forward = 127, .run = run};
    const Walker second = after(scene, start, input, 64);
    // Each tick makes up for a quarter of what the speed lacks.
    double wanted = 0;
    for (int i = 1; i <= 64; ++i) wanted += speed * (1 - std::pow(0.75, i)) / 64;
    EXPECT_NEAR(second.feet.x, 50 + wanted, 1e-6);
    EXPECT_EQ(second.velocity.x, speed);
    EXPECT_NEAR(after(scene, second, input, 64).feet.x, second.feet.x + speed, 1e-12);
    EXPECT_EQ(second.feet.y, 50);
  }
}

TEST_F(InAHall, IsNoFasterOnTheDiagonal) {
  const Walker walker = after(scene, start, {.forward = 127, .right = 127}, 64);
  EXPECT_NEAR(length(walker.velocity), 2.5, 1e-6);
  EXPECT_GT(walker.velocity.y, 0) << "the right of +x is +y";
  const Walker slow = after(scene, start, {.forward = 64}, 64);
  EXPECT_NEAR(slow.velocity.x, 2.5 * 64 / 127, 1e-6);
}

TEST_F(InAHall, TurnsByThousandthsOfADegreeAndLooksUpTo60) {
  Walker walker = walked(scene, start, {.turn = -90500, .pitch = 59000});
  EXPECT_NEAR(walker.angle, 269.5, 1e-12);
  EXPECT_NEAR(walked(scene, walker, {.pitch = 5000}).pitch, 60, 0);
  EXPECT_NEAR(walked(scene, walker, {.pitch = -500000}).pitch, -60, 0);
  walker = after(scene, walker, kForward, 64);
  EXPECT_LT(walker.feet.y, 48) << "269.5 degrees look along -y";
}

TEST_F(InAHall, ComesToRest) {
  const Walker walker = after(scene, after(scene, start, kRun, 64), {}, 128);
  EXPECT_EQ(walker.velocity, Vec3{});
}

TEST_F(InAHall, JumpsAHeightOfSquaredSpeedBy2G) {
  Walker walker = walked(scene, start, {.jump = true});
  double highest = 0;
  int ticks = 1;
  for (; !walker.isOnGround && ticks < 200; ++ticks) {
    highest = std::max(highest, walker.feet.z);
    walker = walked(scene, walker, {});
  }
  // The parabola's top lies between two ticks, at most half a tick off.
  const double top = 3.3 * 3.3 / (2 * 9.81);
  EXPECT_LE(highest, top);
  EXPECT_GE(highest, top - 9.81 / 2 / 128 / 128);
  EXPECT_EQ(walker.feet.z, 0);
  EXPECT_NEAR(ticks, 64 * 2 * 3.3 / 9.81, 1);
}

TEST_F(InAHall, FallsAsTheSquareOfTime) {
  Walker walker = walkerAt(scene, SectorId(0), {50, 50, 41.6}, 0, 0);
  EXPECT_FALSE(walker.isOnGround);
  walker = after(scene, walker, {}, 128);
  EXPECT_NEAR(walker.feet.z, 40 - 9.81 / 2 * 4, 1e-9);
  EXPECT_NEAR(walker.velocity.z, -2 * 9.81, 1e-9);
}

TEST_F(InAHall, SteersLittleInTheAir) {
  Walker walker = walked(scene, after(scene, start, kRun, 64), {.jump = true});
  const double speed = walker.velocity.x;
  walker = after(scene, walker, {.forward = -127}, 16);
  EXPECT_FALSE(walker.isOnGround);
  EXPECT_GT(walker.velocity.x, 0.3 * speed);
  EXPECT_LT(walker.velocity.x, speed);
}

TEST_F(InAHall, FliesWithoutWeightAtEvenSpeed) {
  Walker walker = walked(scene, start, {.up = 127, .toggleFlight = true});
  walker = after(scene, walker, {.up = 127}, 64);
  EXPECT_EQ(walker.velocity.z, 5);
  walker = after(scene, walker, {}, 128);
  const double z = walker.feet.z;
  EXPECT_GT(z, 4);
  EXPECT_EQ(after(scene, walker, {}, 64).feet.z, z);
  walker = after(scene, walked(scene, walker, {.toggleFlight = true}), {}, 128);
  EXPECT_EQ(walker.feet.z, 0) << "with weight again";
}

TEST_F(InAHall, CrouchesToHalfHisHeightAndSpeed) {
  Walker walker = after(scene, start, {.forward = 127, .crouch = true}, 64);
  EXPECT_EQ(walker.crouch, 1);
  EXPECT_NEAR(walker.velocity.x, 1.25, 1e-6);
  EXPECT_NEAR(eyeOf(scene, walker).point.z, 0.8, 1e-9);
  EXPECT_NEAR(eyeOf(scene, after(scene, walker, {}, 16)).point.z, 1.6, 1e-9);
}

TEST_F(InAHall, TheViewBetweenTicksGoesTheShortWayRound) {
  Walker before = start;
  before.angle = 350;
  Walker behind = walked(scene, before, {.forward = 127, .turn = 20000});
  const Eye eye = eyeBetween(scene, before, behind, 0.75);
  EXPECT_NEAR(eye.angle, 5, 1e-9);
  EXPECT_NEAR(eye.point.x, 50 + 0.75 * (behind.feet.x - 50), 1e-12);
}

TEST_F(InAHall, FramesOfAnyLengthKeepHimInTheLevel) {
  for (const double frame : {0.0, 0.15, 0.25, 1.0, 10.0, -1.0}) {
    WalkClock clock;
    Walker walker = start;
    double now = 0;
    for (int i = 0; i < 400; ++i, now += frame) {
      const int ticks = clock.advance(now).ticks;
      EXPECT_LE(ticks, 16);
      const Vec3 from = walker.feet;
      walker = after(scene, walker, kRun, ticks);
      EXPECT_LE(length(walker.feet - from), 5 * 0.25 + 1e-9) << frame;
    }
    if (frame > 0) {
      EXPECT_NEAR(walker.feet.x, 100 - 0.3, 1e-4) << frame;
    }
  }
}

TEST(Walker, IsTheSameWalkAMillionMetresAway) {
  for (const double far : {0.0, 1e6}) {
    const auto v = [&](double x, double y) { return fmt::format("{},{}", far + x, y - far); };
    const auto square = [&](double x0, double x1) {
      return v(x0, 0) + ", " + v(x1, 0) + ", " + v(x1, 8) + ", " + v(x0, 8);
    };
    const std::string solid = "{'texture':'#808080'}";
    const auto to = [](const char* next) {
      return fmt::format("{{'texture':'#808080','next':'{}'}}", next);
    };
    const std::string east = "[" + solid + "," + to("step") + "," + solid + "," + solid + "]";
    const std::string west = "[" + solid + "," + solid + "," + solid + "," + to("room") + "]";
    const LoadedLevel loaded =
        test::levelFrom("{'light':1,'sectors':{" + sectorText("room", square(0, 8), 0, 3, east) +
                        "," + sectorText("step", square(8, 16), 0.375, 3, west) + "}}");
    Walker walker = standing(loaded.scene(), "room", {far + 1, 1 - far, 0}, 20);
    walker = after(loaded.scene(), walker, kRun, 400);
    EXPECT_EQ(loaded.level[walker.sector].name, "step");
    EXPECT_NEAR(walker.feet.x, far + 15.7, 1e-5);
    EXPECT_NEAR(walker.feet.y, 6.69 - far, 2.0);
    EXPECT_EQ(walker.feet.z, 0.375);
  }
}

}  // namespace
}  // namespace hearth
