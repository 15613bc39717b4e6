#include "import/doom/ground_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "map_builder.h"

namespace hearth::doom {

namespace {

/// A hall, a door and a chamber, in a row.
class Passage : public testing::Test, protected MapBuilder {
 protected:
  Passage() {
    for (const int x : {0, 64, 128}) {
      const auto here = sector();
      line({x + 64, 0}, {x, 0}, here);
      line({x, 64}, {x + 64, 64}, here);
    }
    line({0, 0}, {0, 64}, 0);
    line({192, 64}, {192, 0}, 2);
    line({64, 64}, {64, 0}, 0, 1);
    line({128, 0}, {128, 64}, 2, 1);
  }

  Space spaceOf(std::uint32_t sector, Doors doors) {
    findings_.clear();
    return GroundPlan::of(map, doors, findings_)->spaceOf(sector);
  }

  std::vector<ShownPart> partsBetween(std::uint32_t from, std::uint32_t to) {
    static std::optional<GroundPlan> plan;  // parts lead into it
    plan = GroundPlan::of(map, Doors::Closed, findings_).value();
    for (const auto& loop : plan->regions()[from].loops)
      for (const std::uint32_t h : loop)
        if (plan->behind(h).region == to) return plan->shownParts(h);
    return {};
  }

  Findings findings_;
};

TEST_F(Passage, opensDoorsThatAreOpenedFromBefore) {
  map.sectors[1].ceiling = 0;
  map.sectors[2].ceiling = 96;
  map.lines[8].special = 1;
  EXPECT_EQ(spaceOf(1, Doors::Closed).ceiling, 0);
  EXPECT_EQ(spaceOf(1, Doors::Open).ceiling, (96 - 4) / 32.0);
}

TEST_F(Passage, opensDoorsThatAreOpenedFromAfar) {
  map.sectors[1].ceiling = 0;
  map.sectors[1].tag = 7;
  map.lines[0].special = 103;
  map.lines[0].tag = 7;
  EXPECT_EQ(spaceOf(1, Doors::Open).ceiling, 124 / 32.0);
}

TEST_F(Passage, opensTheLeavesOfADoorTogether) {
  map.sectors[1].ceiling = 0;
  map.sectors[2].ceiling = 0;
  map.lines[8].special = 1;
  map.lines[9].special = 1;
  map.sectors[2].tag = 7;
  map.lines[0].special = 103;
  map.lines[0].tag = 7;
  EXPECT_EQ(spaceOf(1, Doors::Open).ceiling, 124 / 32.0);
}

TEST_F(Passage, lowersLifts) {
  map.sectors[1].floor = 64;
  map.sectors[2].floor = 64;
  map.sectors[1].tag = 7;
  map.lines[0].special = 88;
  map.lines[0].tag = 7;
  EXPECT_EQ(spaceOf(1, Doors::Closed).floor, 2);
  EXPECT_EQ(spaceOf(1, Doors::Open).floor, 0);
}

TEST_F(Passage, leavesSectorsWithoutATagAlone) {
  map.sectors[1].ceiling = 0;
  map.lines[0].special = 103;
  EXPECT_EQ(spaceOf(1, Doors::Open).ceiling, 0);
}

TEST_F(Passage, closesASectorWhoseCeilingLiesBelowItsFloor) {
  map.sectors[1].ceiling = -32;
  const Space space = spaceOf(1, Doors::Closed);
  EXPECT_EQ(space.floor, 0);
  EXPECT_EQ(space.ceiling, 0);
  EXPECT_EQ(findings_.size(), 1U);
}

TEST_F(Passage, showsTheStepsOfAWindow) {
  map.sectors[1].floor = 32;
  map.sectors[1].ceiling = 96;
  const auto parts = partsBetween(0, 1);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].part, WallPart::Lower);
  EXPECT_EQ(parts[0].bottom, 0);
  EXPECT_EQ(parts[0].top, 1);
  EXPECT_EQ(parts[0].texture, "LOWER");
  EXPECT_EQ(parts[1].part, WallPart::Upper);
  EXPECT_EQ(parts[1].bottom, 3);
  EXPECT_EQ(parts[1].top, 4);
}

TEST_F(Passage, showsTheUpperStepOfAClosedDoor) {
  map.sectors[1].ceiling = 0;
  const auto parts = partsBetween(0, 1);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].part, WallPart::Upper);
  EXPECT_EQ(parts[0].bottom, 0);
}

TEST_F(Passage, showsOnlyTheLowerStepOfASectorThatBeginsAboveTheCeiling) {
  map.sectors[1].floor = 200;
  map.sectors[1].ceiling = 300;
  const auto parts = partsBetween(0, 1);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].part, WallPart::Lower);
  EXPECT_EQ(parts[0].top, 4);
}

TEST_F(Passage, showsNoStepBetweenSkies) {
  map.sectors[1].ceiling = 64;
  map.sectors[0].ceilingFlat = map.sectors[1].ceilingFlat = kSkyFlat;
  EXPECT_TRUE(partsBetween(0, 1).empty());
}

TEST_F(Passage, hasWhatHangsInItBetweenTheHigherFloorAndTheLowerCeiling) {
  map.sectors[1].floor = 32;
  map.sectors[1].ceiling = 96;
  map.sides[*map.lines[8].sides[0]].middle = "GRATE";
  const auto parts = partsBetween(0, 1);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].part, WallPart::Middle);
  EXPECT_EQ(parts[1].bottom, 1);
  EXPECT_EQ(parts[1].top, 3);
  EXPECT_EQ(parts[1].texture, "GRATE");
  for (const ShownPart& part : partsBetween(1, 0)) EXPECT_NE(part.part, WallPart::Middle);
}

TEST_F(Passage, wearsWhatTheSideBehindWearsWhereThereIsNone) {
  map.lines[8].sides[0].reset();
  map.sides[*map.lines[8].sides[1]].middle = "BACK";
  const auto parts = partsBetween(0, 1);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].part, WallPart::Solid);
  EXPECT_EQ(parts[0].texture, "BACK");
}

}  // namespace

}  // namespace hearth::doom
