#include "worlds/standing_places.h"

#include <gtest/gtest.h>

#include "level/locate.h"
#include "support/level_text.h"

namespace hearth::worlds {
namespace {

using test::levelFrom;
using test::sectorText;

std::string levelText(const std::string& sectors) { return "{'sectors': {" + sectors + "}}"; }

TEST(StandingPlaces, areWhereABodyHasRoom) {
  const LoadedLevel loaded =
      levelFrom(levelText(sectorText("low", "0,0, 9,0, 9,9, 0,9", 1, 2.7) + "," +
                          sectorText("high", "10,0, 19,0, 10,9", 1, 2.8)));
  const Level& level = loaded.level;
  const std::vector<Shot> shots = standingPlaces(level, 30, 1, {16, 10});
  ASSERT_EQ(shots.size(), 30U);
  for (const Shot& shot : shots) {
    EXPECT_EQ(level[shot.sector].name, "high");
    EXPECT_TRUE(contains(loaded.scene(), level[shot.sector], shot.eye, 0));
    EXPECT_NEAR(shot.eye.z, 2.28, 0.01);
    EXPECT_GE(shot.eye.x, 10.1);
    EXPECT_GE(shot.eye.y, 0.1);
  }
}

TEST(StandingPlaces, areNoneWhereThereIsNoRoom) {
  const Level level = levelFrom(levelText(sectorText("low", "0,0, 9,0, 9,9, 0,9", 1, 2.7) + "," +
                                          sectorText("slit", "10,0, 19,0, 19,0.1, 10,0.1", 0, 4)))
                          .level;
  EXPECT_TRUE(standingPlaces(level, 30, 1, {16, 10}).empty());
}

TEST(StandingPlaces, beginWithThePlayersView) {
  const Level level = levelFrom("{'player': {'x': 2, 'y': 3, 'z': 1.6, 'angle': 30}, 'sectors': {" +
                                sectorText("hall", "0,0, 9,0, 9,9, 0,9", 0, 3) + "}}")
                          .level;
  const std::vector<Shot> shots = standingPlaces(level, 1, 1, {16, 10});
  ASSERT_EQ(shots.size(), 2U);
  EXPECT_EQ(shots[0].eye, (Vec3{2, 3, 1.6}));
  EXPECT_EQ(shots[0].angle, 30);
}

}  // namespace
}  // namespace hearth::worlds
