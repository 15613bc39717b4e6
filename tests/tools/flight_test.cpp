#include "hearth/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "level/locate.h"
#include "loaded.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// A flight through the test level of a hall (4 m x 4 m x 3 m) with a garden behind a window in the
/// east, a ramp in the south and an attic above.
class InRooms : public testing::Test {
 protected:
  Flight from(const std::string& sector, Vec3 eye, double angle = 0) const {
    return {sectorNamed(level, sector), eye, angle, 0};
  }

  /// In frames of a 60th of a second.
  Flight fly(Flight flight, const FlightControls& controls, double seconds) const {
    for (int i = 0; i < static_cast<int>(60 * seconds); ++i) {
      flight = advance(level, flight, controls, 1.0 / 60);
      EXPECT_TRUE(contains(level, level[flight.sector], flight.eye, kPositionSlack));
    }
    return flight;
  }

  std::string sectorOf(const Flight& flight) const { return level[flight.sector].name; }

  LoadedLevel rooms = loaded("tests/levels/rooms.json");
  const Level& level = rooms.level;
  const FlightControls forward{.forward = 1};
};

TEST_F(InRooms, AWindowIsAWayOut) {
  const Flight flight = fly(from("hall", {2, 2, 1.5}), forward, 1);
  EXPECT_EQ(sectorOf(flight), "garden");
  EXPECT_NEAR(flight.eye.x, 5, 1e-6);
}

TEST_F(InRooms, TheParapetBelowTheWindowIsNone) {
  const Flight flight = fly(from("hall", {2, 2, 0.5}), forward, 2);
  EXPECT_EQ(sectorOf(flight), "hall");
  EXPECT_NEAR(flight.eye.x, 4, 0.06);
}

TEST_F(InRooms, AWallIsSlidAlong) {
  const Flight flight = fly(from("hall", {1, 1, 1.5}, 135), forward, 2);  // to the lower left
  EXPECT_EQ(sectorOf(flight), "ramp");
  EXPECT_NEAR(flight.eye.x, 0, 0.06);
  EXPECT_GT(flight.eye.y, 4);
}

TEST_F(InRooms, AFlatPortalLeadsUpAndBack) {
  Flight flight = fly(from("hall", {1, 1, 1.5}), {.up = 1}, 1);
  EXPECT_EQ(sectorOf(flight), "attic");
  EXPECT_NEAR(flight.eye.z, 4.5, 1e-6);
  flight = fly(flight, {.up = -1}, 1);
  EXPECT_EQ(sectorOf(flight), "hall");
}

TEST_F(InRooms, ARampLiftsTheEye) {
  const Flight flight = fly(from("hall", {2, 3, 0.2}, 90), forward, 1.5);
  EXPECT_EQ(sectorOf(flight), "ramp");
  EXPECT_GT(flight.eye.y, 7);
  EXPECT_NEAR(flight.eye.z, level[flight.sector].airBottom(flight.eye.xy()), 1e-6);
}

TEST_F(InRooms, SidewaysIsToTheRight) {
  const Flight flight = fly(from("hall", {1, 1, 1.5}), {.right = 1}, 0.5);
  EXPECT_NEAR(flight.eye.x, 1, 1e-9);
  EXPECT_GT(flight.eye.y, 2);
}

TEST_F(InRooms, TurningWrapsAndPitchHasLimits) {
  Flight flight = from("hall", {1, 1, 1.5}, 350);
  flight = advance(level, flight, {.turnDegrees = 20, .pitchDegrees = 100}, 0);
  EXPECT_DOUBLE_EQ(flight.angle, 10);
  EXPECT_DOUBLE_EQ(flight.pitch, 60);
  flight = advance(level, flight, {.turnDegrees = -10 - 1e-30, .pitchDegrees = -200}, 0);
  EXPECT_DOUBLE_EQ(flight.angle, 0);
  EXPECT_DOUBLE_EQ(flight.pitch, -60);
}

TEST_F(InRooms, ABrokenClockIsNoLeap) {
  const Flight start = from("hall", {1, 2, 1.5});
  const Vec3 quarter = advance(level, start, forward, 0.25).eye;
  EXPECT_NEAR(quarter.x, 1.75, 1e-9);
  EXPECT_EQ(advance(level, start, forward, 1e9).eye, quarter);
  EXPECT_EQ(advance(level, start, forward, -1).eye, start.eye);
  EXPECT_EQ(advance(level, start, forward, std::numeric_limits<double>::quiet_NaN()).eye,
            start.eye);
}

TEST(Flight, NeverLeavesTheLevelAndGetsAround) {
  const LoadedLevel tutorial = loaded("levels/tutorial.json");
  const Level& level = tutorial.level;
  ASSERT_TRUE(level.player);
  Flight flight{level.player->sector, level.player->eye, level.player->angle, 0};
  std::mt19937 random(7);
  const auto oneOf3 = [&] { return static_cast<double>(random() % 3) - 1; };
  std::vector<bool> visited(level.sectors.size(), false);
  for (int stretch = 0; stretch < 400; ++stretch) {
    const FlightControls controls{1, oneOf3(), oneOf3(), oneOf3(), random() % 2 == 0, 0, 0};
    for (int frame = 0; frame < 20; ++frame) {
      flight = advance(level, flight, controls, 0.03);
      ASSERT_TRUE(contains(level, level[flight.sector], flight.eye, kPositionSlack))
          << level[flight.sector].name << " stretch " << stretch;
      visited[flight.sector.index()] = true;
    }
  }
  EXPECT_GE(std::ranges::count(visited, true), 8);
}

}  // namespace

}  // namespace hearth
