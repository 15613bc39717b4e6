// The player's body walks the keep from the road to its ends, past all that moves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "load/load.h"
#include "support/in_tree.h"
#include "walk/moving_level.h"

namespace hearth {
namespace {

class KeepTour : public testing::Test {
 protected:
  KeepTour()
      : loaded_(loadLevel(test::inTree("levels/keep.json")).loaded.value()),
        moving_(loaded_.scene()),
        walker_(walkerAt(moving_.scene(), level().player->sector, level().player->eye, 0, 0)) {}

  const Level& level() const { return loaded_.level; }
  std::string sector() const { return level()[walker_.sector].name; }

  /// Turns to each place in turn and goes straight there.
  void walk(const std::vector<Vec2>& places) {
    for (const Vec2 place : places) {
      constexpr int kMaxTicks = 1200;
      for (int i = 0; i < kMaxTicks && !isNear(place); ++i) {
        const Vec2 apart = place - walker_.feet.xy();
        const double angle = std::atan2(apart.y, apart.x) * 180 / std::numbers::pi;
        const double turn = std::remainder(angle - walker_.angle, 360);
        tick({.forward = kFullSpeed, .turn = static_cast<int>(std::lround(1000 * turn))});
      }
      ASSERT_TRUE(isNear(place)) << "stuck in " << sector() << " at " << walker_.feet.x << ", "
                                 << walker_.feet.y << " on the way to " << place.x << ", "
                                 << place.y;
    }
  }

  void tick(const WalkInput& input) { walker_ = moving_.ticked(walker_, input); }
  /// Presses the use key where the walker looks.
  void use() { tick({.use = true}); }
  void rest(int seconds) {
    for (int i = 0; i < seconds * kTicksPerSecond; ++i) tick({});
  }

  /// Along the middle of the stair tower's steps, from one to another.
  void climb(int from, int to) {
    for (int step = from; step != to; step += from < to ? 1 : -1) walk({onStep(step)});
    walk({onStep(to)});
  }

  LoadedLevel loaded_;
  MovingLevel moving_;
  Walker walker_;

 private:
  bool isNear(Vec2 place) const {
    const Vec2 apart = place - walker_.feet.xy();
    return std::sqrt(dot(apart, apart)) < 0.2;
  }

  static Vec2 onStep(int step) {
    const double turn = (90 + 30 * step) * std::numbers::pi / 180;
    return {5.5 + 1.5 * std::cos(turn), 12.196 + 1.5 * std::sin(turn)};
  }
};

TEST_F(KeepTour, LeadsOverTheBridgeIntoTheHall) {
  walk({{17, 37}});
  EXPECT_EQ(sector(), "bridge");
  walk({{17, 31}, {17, 16}, {17.4, 13}, {17.4, 9}, {23, 6.8}});
  EXPECT_EQ(sector(), "hall-dais-middle");
  walk({{17.4, 9}, {10, 7}});
  EXPECT_EQ(sector(), "screens");
}

TEST_F(KeepTour, LeadsIntoTheChapelAndUpToItsAltar) {
  walk({{17, 29}, {20, 16.75}, {23, 16.75}, {29, 16.75}});
  EXPECT_EQ(sector(), "chancel-aisle");
}

TEST_F(KeepTour, LeadsUpTheStairsToGalleryRampartsAndGate) {
  walk({{17, 18}, {9, 16.5}, {5.5, 16.5}});
  climb(0, 9);
  walk({{8.3, 12.05}, {10.5, 9}});
  EXPECT_EQ(sector(), "hall-gallery-south");
  walk({{8.6, 12.05}});
  climb(9, 15);
  walk({{1.5, 12.1}, {0.9, 15}, {0.9, 18}, {1.4, 28}, {1.3, 30}, {2.5, 31.7}, {8, 31.8}});
  EXPECT_EQ(sector(), "rampart-south-west");
  walk({{9, 30.9}, {13, 30.9}, {17, 32}});
  EXPECT_EQ(sector(), "gate-top");
}

TEST_F(KeepTour, LeadsDownToTheCryptAndUpToTheLookOut) {
  walk({{17, 18}, {9, 16.5}, {5.5, 16.5}});
  climb(0, -12);
  walk({{5.5, 14.3}});
  use();
  walk({{5.5, 17}, {5.5, 22.4}, {10, 22.5}});
  EXPECT_EQ(sector(), "crypt");
  rest(5);
  walk({{5.5, 22.4}, {5.5, 16}});
  use();
  climb(-12, 29);
  EXPECT_NEAR(walker_.feet.z, 11.2, 0.01);
}

TEST_F(KeepTour, LeadsByTheLiftUpAndDown) {
  walk({{17, 18}, {9, 16.6}, {2, 16.6}});
  EXPECT_EQ(sector(), "lift");
  use();
  rest(5);
  EXPECT_EQ(walker_.feet.z, 6);
  walk({{0.9, 16.6}, {0.9, 18}});
  EXPECT_EQ(sector(), "rampart-west");
  rest(10);
  walk({{0.9, 16.6}, {1.25, 16.6}});
  use();
  rest(5);
  walk({{2, 16.6}});
  EXPECT_EQ(walker_.feet.z, 6);
  rest(8);
  EXPECT_EQ(walker_.feet.z, 0);
  walk({{5, 16.6}});
  EXPECT_EQ(sector(), "courtyard");
}

TEST_F(KeepTour, PassesThePortcullisFromEitherSideAndItShutsAgain) {
  const auto portcullis =
      std::ranges::find(level().movers, "portcullis", &Mover::name) - level().movers.begin();
  const auto share = [&] { return moving_.movers()[static_cast<std::size_t>(portcullis)].share; };
  walk({{17, 35}});
  EXPECT_GT(share(), 0);
  walk({{17, 28}});
  rest(7);
  EXPECT_EQ(share(), 0);
  walk({{17, 44}});
  rest(7);
  EXPECT_EQ(share(), 0);
}

TEST_F(KeepTour, FallsThroughTheOpeningIntoTheCrypt) {
  walk({{17, 29}, {16, 22.5}, {13, 22.5}});
  EXPECT_LT(walker_.feet.z, -0.5);
}

}  // namespace
}  // namespace hearth
