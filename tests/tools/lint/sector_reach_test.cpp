#include "lint/sector_reach.h"

#include <gtest/gtest.h>

#include "support/level_text.h"

namespace hearth {
namespace {

using Reached = std::vector<bool>;

struct Heights {
  double floor;
  double ceiling;
};

/// Walls to the north, east, south and west.
std::string wallsText(const std::string& east, const std::string& west) {
  const std::string solid = "{'texture': '#808080'}";
  const auto portal = [](const std::string& to) { return "{'texture': '#808080', " + to + "}"; };
  return "[" + solid + "," + (east.empty() ? solid : portal(east)) + "," + solid + "," +
         (west.empty() ? solid : portal(west)) + "]";
}

/// A hall, a sector and a chamber in a row to the east. `start` is what the hall's portal says
/// besides.
Level row(Heights middle, double chamberFloor, const std::string& mover, const std::string& start) {
  using test::sectorText;
  return test::levelFrom(
             "{'light': 1, 'player': {'x': 1, 'y': 1, 'z': 1.6, 'angle': 0}, 'movers': {" + mover +
             "}, 'sectors': {" +
             sectorText("hall", "0,0, 2,0, 2,2, 0,2", 0, 4,
                        wallsText("'next': 'middle'" + start, "")) +
             "," +
             sectorText("middle", "2,0, 4,0, 4,2, 2,2", middle.floor, middle.ceiling,
                        wallsText("'next': 'chamber'", "'next': 'hall'")) +
             "," +
             sectorText("chamber", "4,0, 6,0, 6,2, 4,2", chamberFloor, 7,
                        wallsText("", "'next': 'middle'")) +
             "}}")
      .level;
}

Reached reachedSectors(const Level& level) {
  const Passages passages(level, level.player->stepHeight, level.player->height);
  const Reach reach(level, passages);
  Reached reached;
  for (const Sector& sector : level.sectors) reached.push_back(reach.comesTo(sector.id));
  return reached;
}

TEST(Reach, goesThroughDoorsThatAreOpened) {
  const std::string door = "'door': {'sectors': 'middle', 'part': 'ceiling', 'to': 3}";
  EXPECT_EQ(reachedSectors(row({0, 0}, 0, door, ", 'use': 'door'")), (Reached{true, true, true}));
  EXPECT_EQ(reachedSectors(row({0, 0}, 0, door, "")), (Reached{true, false, false}));
}

TEST(Reach, goesUpWithLifts) {
  const std::string lift = "'lift': {'sectors': 'middle', 'part': 'floor', 'to': 0}";
  EXPECT_EQ(reachedSectors(row({2, 7}, 2, lift, ", 'use': 'lift'")), (Reached{true, true, true}));
  EXPECT_EQ(reachedSectors(row({2, 7}, 2, lift, "")), (Reached{true, false, false}));
  EXPECT_EQ(reachedSectors(row({0, 7}, 2, "", "")), (Reached{true, true, false}));
}

TEST(Reach, usesWallsFromBeside) {
  const Level level = row({2, 7}, 2, "", "");
  const Passages passages(level, level.player->stepHeight, level.player->height);
  const Reach reach(level, passages);
  EXPECT_TRUE(reach.mayUseWallsOf(SectorId(1)));
  EXPECT_FALSE(reach.mayUseWallsOf(SectorId(2)));
}

TEST(Reach, tellsWhichMoversMustBeStarted) {
  const std::string door = "'door': {'sectors': 'middle', 'part': 'ceiling', 'to': 3}";
  const Level level = row({0, 0}, 0, door, ", 'use': 'door'");
  const Passages passages(level, level.player->stepHeight, level.player->height);
  const Reach reach(level, passages);
  EXPECT_EQ(reach.moversTo(SectorId(0)), std::vector<std::size_t>{});
  EXPECT_EQ(reach.moversTo(SectorId(2)), std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace hearth
