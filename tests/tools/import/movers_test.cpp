#include "import/doom/movers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "map_builder.h"

namespace hearth::doom {

namespace {

constexpr std::uint16_t kTag = 7;

/// A hall, a sector that moves and a chamber, in a row; the lines between them are 6, from the
/// hall, and 7, from the chamber.
class MoversOfAMap : public testing::Test, protected MapBuilder {
 protected:
  MoversOfAMap() {
    for (const int x : {0, 64, 128}) {
      const auto here = sector();
      line({x + 64, 0}, {x, 0}, here);
      line({x, 64}, {x + 64, 64}, here);
    }
    line({64, 64}, {64, 0}, 0, 1);
    line({128, 0}, {128, 64}, 2, 1);
    map.sectors[1].tag = kTag;
  }

  void setSpecial(std::size_t line, std::uint16_t special, std::uint16_t tag = kTag) {
    map.lines[line].special = special;
    map.lines[line].tag = tag;
  }

  const MapMovers& find() {
    movers_ = moversOf(map, heightsOf(map, Doors::Moving));
    return movers_;
  }

  /// That of the only mover, which the only line starts.
  MapMover moverFor(std::uint16_t special) {
    setSpecial(0, special);
    find();
    if (movers_.movers.size() != 1U) {
      ADD_FAILURE() << special << ": " << movers_.movers.size();
      return {};
    }
    EXPECT_EQ(movers_.movers[0].lines, std::vector<std::uint32_t>{0});
    EXPECT_EQ(movers_.movers[0].sectors, std::vector<std::uint32_t>{1});
    EXPECT_TRUE(movers_.lines.at(0).isImported());
    return movers_.movers[0];
  }

  std::string reasonFor(std::uint16_t special, std::uint16_t tag = kTag) {
    setSpecial(0, special, tag);
    find();
    EXPECT_TRUE(movers_.movers.empty());
    return movers_.lines.at(0).reason;
  }

  MapMovers movers_;
};

TEST_F(MoversOfAMap, areDoorsThatArePushedAtFromBothSides) {
  map.sectors[1].ceiling = 0;
  map.sectors[2].ceiling = 96;
  setSpecial(6, 1, 0);
  setSpecial(7, 28, 0);  // with a key
  const MapMovers& found = find();
  ASSERT_EQ(found.movers.size(), 1U);
  const MapMover& door = found.movers[0];
  EXPECT_EQ(door.name, "door 1");
  EXPECT_EQ(door.part, FlatPart::Ceiling);
  EXPECT_EQ(door.from, 0);
  EXPECT_EQ(door.motion, (Motion{96 - 4, 2.1875, 150.0 / 35, false}));
  EXPECT_EQ(door.lines, (std::vector<std::uint32_t>{6, 7}));
}

TEST_F(MoversOfAMap, areDoorsThatStayOpen) {
  map.sectors[1].ceiling = 0;
  EXPECT_EQ(moverFor(103).motion, (Motion{124, 2.1875, std::nullopt, false}));
  EXPECT_EQ(moverFor(112).motion, (Motion{124, 8.75, std::nullopt, false}));
}

TEST_F(MoversOfAMap, areDoorsThatClose) {
  const MapMover door = moverFor(3);
  EXPECT_EQ(door.from, 128);
  EXPECT_EQ(door.motion, (Motion{0, 2.1875, std::nullopt, false}));
  EXPECT_EQ(moverFor(76).motion.wait, 30);
}

TEST_F(MoversOfAMap, areLifts) {
  map.sectors[1].floor = map.sectors[2].floor = 64;
  const MapMover lift = moverFor(62);
  EXPECT_EQ(lift.name, "lift 1");
  EXPECT_EQ(lift.part, FlatPart::Floor);
  EXPECT_EQ(lift.from, 64);
  EXPECT_EQ(lift.motion, (Motion{0, 4.375, 3, false}));
  EXPECT_EQ(moverFor(121).motion.speed, 8.75);
}

TEST_F(MoversOfAMap, areFloorsThatSink) {
  map.sectors[0].floor = 16;
  map.sectors[1].floor = 64;
  EXPECT_EQ(moverFor(23).motion, (Motion{0, 1.09375, std::nullopt, false}));
  EXPECT_EQ(moverFor(19).motion.to, 16);
  EXPECT_EQ(moverFor(70).motion, (Motion{24, 4.375, std::nullopt, false}));
}

TEST_F(MoversOfAMap, areFloorsThatRise) {
  map.sectors[0].floor = 40;
  map.sectors[2].floor = 16;
  map.sectors[2].ceiling = 96;
  EXPECT_EQ(moverFor(18).motion, (Motion{16, 1.09375, std::nullopt, false}));
  EXPECT_EQ(moverFor(20).motion, (Motion{16, 0.546875, std::nullopt, false}));
  EXPECT_EQ(moverFor(5).motion.to, 96);
  EXPECT_EQ(moverFor(56).motion.to, 88);
  EXPECT_EQ(moverFor(58).motion.to, 24);
  EXPECT_EQ(moverFor(14).motion.to, 32);
}

TEST_F(MoversOfAMap, areCeilings) {
  map.sectors[0].ceiling = 256;
  EXPECT_EQ(moverFor(40).motion, (Motion{256, 1.09375, std::nullopt, false}));
  EXPECT_EQ(moverFor(41).motion.to, 0);
  EXPECT_EQ(moverFor(44).motion.to, 8);
}

TEST_F(MoversOfAMap, arePlatformsThatNeverRest) {
  map.sectors[1].floor = map.sectors[2].floor = 64;
  EXPECT_EQ(moverFor(87).motion, (Motion{0, 1.09375, std::nullopt, true}));
  map.sectors[1].floor = 32;
  EXPECT_EQ(reasonFor(87), "it moves a floor that begins between its ends");
}

/// The second step has the flat of the first and lies behind a line whose front that is.
TEST_F(MoversOfAMap, areStepsOfStairsThatBuild) {
  std::swap(map.lines[7].from, map.lines[7].to);
  std::swap(map.lines[7].sides[0], map.lines[7].sides[1]);
  setSpecial(0, 7);
  const MapMovers& found = find();
  ASSERT_EQ(found.movers.size(), 2U);
  EXPECT_EQ(found.movers[0].name, "step 1");
  EXPECT_EQ(found.movers[0].motion, (Motion{8, 0.2734375, std::nullopt, false}));
  EXPECT_EQ(found.movers[1].name, "step 2");
  EXPECT_EQ(found.movers[1].motion.to, 16);
  map.sectors[2].floorFlat = "OTHER";
  EXPECT_EQ(find().movers.size(), 1U);
}

TEST_F(MoversOfAMap, haveAllSectorsThatTheSameLinesMoveInTheSameWay) {
  map.sectors[1].floor = map.sectors[2].floor = 64;
  map.sectors[2].tag = kTag;
  map.sectors.push_back(map.sectors[1]);
  line({192, 0}, {192, 64}, 0, 3);
  setSpecial(0, 23);
  setSpecial(1, 60);
  const MapMovers& found = find();
  ASSERT_EQ(found.movers.size(), 1U);
  EXPECT_EQ(found.movers[0].sectors, (std::vector<std::uint32_t>{1, 3}))
      << "2 has no lower floor around";
  EXPECT_EQ(found.movers[0].lines, (std::vector<std::uint32_t>{0, 1}));
}

TEST_F(MoversOfAMap, stayOpenWhereOneOfTheirLinesLetsThem) {
  map.sectors[1].ceiling = 0;
  setSpecial(6, 1, 0);
  setSpecial(0, 103);
  const MapMovers& found = find();
  ASSERT_EQ(found.movers.size(), 1U);
  EXPECT_EQ(found.movers[0].motion.wait, std::nullopt);
  EXPECT_EQ(found.movers[0].lines, (std::vector<std::uint32_t>{0, 6}));
}

TEST_F(MoversOfAMap, areLiftsWhereAnotherLineLowersThemForGood) {
  map.sectors[1].floor = map.sectors[2].floor = 64;
  setSpecial(0, 23);
  setSpecial(1, 88);
  ASSERT_EQ(find().movers.size(), 1U);
  EXPECT_EQ(movers_.movers[0].motion.wait, 3);
}

TEST_F(MoversOfAMap, areLiftsThatComeBackDownWhereAnotherLineRaisesThem) {
  map.sectors[2].floor = 64;
  setSpecial(0, 18);
  setSpecial(1, 62);
  const MapMovers& found = find();
  ASSERT_EQ(found.movers.size(), 1U);
  EXPECT_EQ(found.movers[0].motion, (Motion{64, 4.375, 3, false}));
  EXPECT_EQ(found.movers[0].lines, (std::vector<std::uint32_t>{0, 1}));
}

TEST_F(MoversOfAMap, doNotCloseWhatAnotherLineOpens) {
  map.sectors[1].ceiling = 124;
  setSpecial(0, 3);
  setSpecial(1, 103);
  const MapMovers& found = find();
  EXPECT_TRUE(found.movers.empty());
  EXPECT_EQ(found.lines[0].reason, "another line moves the same floor or ceiling elsewhere");
  EXPECT_EQ(found.lines[1].reason, "what it moves stands there already");
}

TEST_F(MoversOfAMap, sinkWhereOtherLinesRaiseThem) {
  map.sectors[0].floor = 64;
  map.sectors[1].floor = 32;
  setSpecial(0, 18);
  setSpecial(1, 23);
  const MapMovers& found = find();
  ASSERT_EQ(found.movers.size(), 1U);
  EXPECT_EQ(found.movers[0].motion.to, 0);
  EXPECT_FALSE(found.lines[0].isImported());
}

TEST_F(MoversOfAMap, doNotMeetTheOtherFlat) {
  map.sectors[0].floor = 64;
  setSpecial(0, 18);
  setSpecial(1, 41);
  const MapMovers& found = find();
  ASSERT_EQ(found.movers.size(), 1U);
  EXPECT_EQ(found.movers[0].part, FlatPart::Floor);
  EXPECT_EQ(found.lines[1].reason, "its ceiling would meet a floor that moves");
}

TEST_F(MoversOfAMap, areNoneOfWhatIsNamedWithItsReason) {
  EXPECT_EQ(reasonFor(1000), "its type is none of Doom's");
  EXPECT_EQ(reasonFor(11), "it ends the map");
  EXPECT_EQ(reasonFor(97), "it teleports");
  EXPECT_EQ(reasonFor(35), "it changes light");
  EXPECT_EQ(reasonFor(48), "its texture scrolls");
  EXPECT_EQ(reasonFor(25), "it starts a crusher");
  EXPECT_EQ(reasonFor(57), "it stops what another line started");
  EXPECT_EQ(reasonFor(46), "a shot starts it");
  EXPECT_EQ(reasonFor(30), "it moves a floor by a texture's height");
  EXPECT_EQ(reasonFor(9), "it moves a floor and a ring around it");
  EXPECT_EQ(reasonFor(103, 0), "it has no tag");
  EXPECT_EQ(reasonFor(103, 99), "no sector has its tag");
  EXPECT_EQ(reasonFor(1), "nothing lies behind it");
  EXPECT_EQ(reasonFor(23), "what it moves stands there already");
  EXPECT_EQ(reasonFor(18), "nothing around says where it stops");
  EXPECT_EQ(reasonFor(140), "a floor would pass its ceiling");
  map.sectors[1].ceilingFlat = kSkyFlat;
  EXPECT_EQ(reasonFor(3), "it moves sky");
}

TEST_F(MoversOfAMap, nameTheSectorsThatALineOfOthersDoesNotMove) {
  map.sectors[1].floor = 64;
  map.sectors[2].tag = kTag;
  setSpecial(0, 23);
  const MapMovers& found = find();
  EXPECT_TRUE(found.lines[0].isImported());
  ASSERT_EQ(found.findings.size(), 1U);
  EXPECT_EQ(found.findings[0].part, Part::Sector);
  EXPECT_EQ(found.findings[0].number, 2U);
}

TEST_F(MoversOfAMap, loseLinesThatNobodyReachesAndSectorsWithoutSpace) {
  map.sectors[1].floor = 64;
  setSpecial(0, 23);
  setSpecial(1, 23);
  const MapMovers all = find();
  movers_.keep([](std::uint32_t line) { return line == 1 ? std::size_t{1} : std::size_t{0}; },
               [](std::uint32_t) { return true; });
  ASSERT_EQ(movers_.movers.size(), 1U);
  EXPECT_EQ(movers_.movers[0].lines, std::vector<std::uint32_t>{1});
  EXPECT_EQ(movers_.lines[0].reason, "no player can reach it");
  EXPECT_TRUE(movers_.lines[1].isImported());
  movers_ = all;
  movers_.keep([](std::uint32_t) { return std::size_t{1}; },
               [](std::uint32_t sector) { return sector != 1; });
  EXPECT_TRUE(movers_.movers.empty());
  EXPECT_EQ(movers_.lines[0].reason, "what it moves has no space");
}

TEST_F(MoversOfAMap, areNotWithoutEnd) {
  map.lines.clear();
  for (int i = 0; i < 400; ++i) {
    map.sectors.push_back({i, 2000, "FLOOR", "CEIL", 160, 0, kTag});
    map.lines.push_back({0, 0, 0, 58, kTag, {}});
  }
  const MapMovers& found = find();
  std::size_t starts = 0;
  for (const MapMover& mover : found.movers) starts += mover.lines.size();
  EXPECT_LE(starts, 100'000U);
  EXPECT_GT(starts, 99'000U);
  movers_.keep([](std::uint32_t) { return std::size_t{100}; }, [](std::uint32_t) { return true; });
  EXPECT_EQ(movers_.movers.size(), 2U) << "400 lines of 100 walls start each";
}

}  // namespace

}  // namespace hearth::doom
