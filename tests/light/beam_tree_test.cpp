// What beams say of points that a light sees, and where they say nothing.

#include "light/beam_tree/beam_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "support/level_text.h"

namespace hearth {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
const std::string kSolid = "{'texture':'#808080'}";

/// What beams say of the points of a floor between two corners; nothing where they know nothing.
std::optional<bool> areLit(const BeamTree& beams, const Level& level, const std::string& name,
                           Vec2 least, Vec2 most) {
  const auto sector = std::ranges::find(level.sectors, name, &Sector::name);
  const SectorId id(static_cast<std::size_t>(sector - level.sectors.begin()));
  const double z = sector->floor.z;
  const std::vector<Vec3> corners = {
      {least.x, least.y, z}, {most.x, least.y, z}, {most.x, most.y, z}, {least.x, most.y, z}};
  const BeamTree::Points points = beams.pointsBetween(corners);
  if (!beams.knows(id, {{0, 0, z}, {0, 0, 1}}, points)) return std::nullopt;
  BeamTree::Candidates candidates;
  if (beams.find(id, nullptr, points, candidates)) return true;
  if (candidates.empty()) return false;
  return std::nullopt;
}

BeamTree beamsFrom(const Scene& scene, Vec3 position, const std::string& name,
                   const BeamLimits& limits = {kEndless, 1 << 20, {}}) {
  const std::vector<Sector>& sectors = scene.level().sectors;
  const auto sector = std::ranges::find(sectors, name, &Sector::name);
  const SectorId id(static_cast<std::size_t>(sector - sectors.begin()));
  return {scene, {position, id}, limits};
}

/// Two rooms side by side, the second with its floor at `z`.
LoadedLevel twoRooms(double z, const std::string& second = "") {
  return test::levelFrom("{'light':0,'sectors':{" +
                         test::sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3,
                                          "[" + kSolid + ",{'next':'east','texture':'#808080'" +
                                              second + "}," + kSolid + "," + kSolid + "]") +
                         "," +
                         test::sectorText("east", "4,0, 8,0, 8,4, 4,4", z, 3,
                                          "[" + kSolid + "," + kSolid + "," + kSolid +
                                              ",{'next':'west','texture':'#808080'}]") +
                         "}}");
}

TEST(BeamTree, seeBesideAPillarAndNotBehindIt) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light': 0, 'sectors': {'room': {'floor': {'z': 0, 'texture': '#808080'},"
      "'ceiling': {'z': 3, 'texture': '#808080'}, 'loops': {"
      "'border': {'v': [0,0, 10,0, 10,10, 0,10], 'walls': {'texture': '#808080'}},"
      "'pillar': {'v': [4,4, 4,6, 6,6, 6,4], 'walls': {'texture': '#808080'}}}}}}");
  const BeamTree beams = beamsFrom(loaded.scene(), {1, 5, 2}, "room");
  const auto outcome = [&](Vec2 least, Vec2 most) {
    return areLit(beams, loaded.level, "room", least, most);
  };
  EXPECT_EQ(outcome({2, 2}, {3, 3}), true);
  EXPECT_EQ(outcome({7, 4.5}, {8, 5.5}), false);
  EXPECT_EQ(outcome({7, 2}, {8, 5}), std::nullopt) << "across the edge of its shadow";
  const double edge = 5 - 6.0 / 3;  // where the line from the light past (4, 4) is at x = 7
  EXPECT_EQ(outcome({7, edge - 1e-5}, {7, edge - 1e-5}), true);
  EXPECT_EQ(outcome({7, edge + 1e-5}, {7, edge + 1e-5}), false);
  EXPECT_EQ(outcome({7, edge}, {7, edge}), std::nullopt) << "rounding decides";
}

TEST(BeamTree, seeOverAStepFromItsFarEdgeOn) {
  const LoadedLevel loaded = twoRooms(-1);
  // From 1 m above the step's edge and 2 m before it, the floor 1 m below is seen 2 m behind it.
  const BeamTree beams = beamsFrom(loaded.scene(), {2, 2, 1}, "west");
  const auto outcome = [&](double x) {
    return areLit(beams, loaded.level, "east", {x, 2}, {x, 2});
  };
  EXPECT_EQ(outcome(6 - 1e-4), false);
  EXPECT_EQ(outcome(6), std::nullopt);
  EXPECT_EQ(outcome(6 + 1e-4), true);
}

TEST(BeamTree, seeNothingBeyondTheirReach) {
  const LoadedLevel loaded = twoRooms(0);
  EXPECT_EQ(areLit(beamsFrom(loaded.scene(), {1, 2, 1}, "west", {2, 1 << 20, {}}), loaded.level,
                   "east", {5, 1}, {6, 2}),
            false);
  EXPECT_EQ(areLit(beamsFrom(loaded.scene(), {1, 2, 1}, "west", {4, 1 << 20, {}}), loaded.level,
                   "east", {5, 1.5}, {6, 2}),
            true);
}

TEST(BeamTree, sayNothingWhereTheyWouldTakeTooMuchMemory) {
  const LoadedLevel loaded = twoRooms(0);
  const auto near = [&](std::size_t maxBytes) {
    return areLit(beamsFrom(loaded.scene(), {1, 2, 1}, "west", {kEndless, maxBytes, {}}),
                  loaded.level, "west", {2.5, 1.5}, {2.6, 1.6});
  };
  EXPECT_EQ(near(1 << 20), true);
  EXPECT_EQ(near(100), std::nullopt);
}

TEST(BeamTree, sayTheSameWithinTheirRegionAndNothingBesideIt) {
  const LoadedLevel loaded = twoRooms(-1);
  const BeamTree all = beamsFrom(loaded.scene(), {2, 2, 1}, "west");
  const Box region{{5, 1}, {7, 3}};
  const BeamTree some = beamsFrom(loaded.scene(), {2, 2, 1}, "west", {kEndless, 1 << 20, region});
  int lit = 0;
  for (double x = 4.25; x < 8; x += 0.25)
    for (double y = 0.25; y < 4; y += 0.25) {
      const auto outcome = [&](const BeamTree& beams) {
        return areLit(beams, loaded.level, "east", {x, y}, {x + 0.1, y + 0.1});
      };
      const bool isIn = region.contains({x, y}) && region.contains({x + 0.1, y + 0.1});
      EXPECT_EQ(outcome(some), isIn ? outcome(all) : std::nullopt) << x << ' ' << y;
      lit += outcome(some) == true ? 1 : 0;
    }
  EXPECT_GT(lit, 10);
}

TEST(BeamTree, sayNothingOfALightAlongTheFloor) {
  const LoadedLevel loaded = twoRooms(0);
  EXPECT_EQ(
      areLit(beamsFrom(loaded.scene(), {1, 2, 1e-7}, "west"), loaded.level, "west", {2, 1}, {3, 2}),
      std::nullopt);
}

TEST(BeamTree, sayNothingForSureBehindATextureWithHoles) {
  const LoadedLevel loaded = twoRooms(0, ",'middle':'#808080 1,1'");
  const BeamTree beams = beamsFrom(loaded.scene(), {1, 2, 1}, "west");
  EXPECT_EQ(areLit(beams, loaded.level, "east", {5, 1.5}, {6, 2}), std::nullopt);
  EXPECT_EQ(areLit(beams, loaded.level, "west", {2.5, 1.5}, {2.6, 1.6}), true);
}

TEST(BeamTree, comeDownThroughAFlatPortalAsFarAsItsEdge) {
  // A shaft of 2 x 2 m above the middle of a cellar of 6 x 2 m, in three sectors.
  const std::string walls = "{'texture':'#808080'}";
  const LoadedLevel loaded = test::levelFrom(
      "{'light':0,'sectors':{"
      "'shaft':{'floor':{'z':3,'next':'shaft-middle'},'ceiling':{'z':6,'texture':'#808080'},"
      "'loops':{'border':{'v':[2,0, 4,0, 4,2, 2,2],'walls':" +
      walls +
      "}}},"
      "'middle':{'floor':{'z':0,'texture':'#808080'},'ceiling':{'z':3,'next':'shaft-middle'},"
      "'loops':{'border':{'v':[2,0, 4,0, 4,2, 2,2],'walls':[" +
      kSolid + ",{'next':'right'}," + kSolid + ",{'next':'left'}]}}}," +
      test::sectorText("left", "0,0, 2,0, 2,2, 0,2", 0, 3,
                       "[" + kSolid + ",{'next':'middle'}," + kSolid + "," + kSolid + "]") +
      "," +
      test::sectorText("right", "4,0, 6,0, 6,2, 4,2", 0, 3,
                       "[" + kSolid + "," + kSolid + "," + kSolid + ",{'next':'middle'}]") +
      "}}");
  // 2 m above the portal, 1.5 m from its right edge: 3 m below it, light comes 2.25 m beyond that.
  const BeamTree beams = beamsFrom(loaded.scene(), {2.5, 1, 5}, "shaft");
  const auto outcome = [&](const std::string& name, double x) {
    return areLit(beams, loaded.level, name, {x, 1}, {x, 1});
  };
  EXPECT_EQ(outcome("middle", 3), true);
  EXPECT_EQ(outcome("right", 5.9), true);
  EXPECT_EQ(outcome("left", 2 - 0.75 + 1e-4), true);
  EXPECT_EQ(outcome("left", 2 - 0.75 - 1e-4), false);
}

}  // namespace
}  // namespace hearth
