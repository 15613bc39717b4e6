#include <gtest/gtest.h>

#include "load_text.h"

namespace hearth {
namespace {

constexpr std::string_view kLegend =
    "'legend': {'#': {'wall': '#a08c78'}, '.': {'floor': {'texture': '#404040'}, 'ceiling': {'z': "
    "3, 'texture': '#202020'}}, 's': {'floor': {'z': 0.5, 'texture': '#505050'}, 'ceiling': {'z': "
    "2, 'texture': '#303030'}, 'light': 0.25, 'upper': '#aa0000', 'lower': '#00aa00'}}";

LoadedLevel loadGrid(const std::string& rows, const std::string& more = "") {
  LoadResult result = loadText("{'light': 0.5, 'grid': {" + more + "'rows': [" + rows + "], " +
                               std::string(kLegend) + "}}");
  EXPECT_EQ(countErrors(result), 0u) << listed(result);
  if (!result.loaded) std::abort();
  return *std::move(result.loaded);
}

std::vector<std::string> sectorNames(const Level& level) {
  std::vector<std::string> names;
  for (const Sector& sector : level.sectors) names.push_back(sector.name);
  return names;
}

/// Where the segments of a loop begin, in order.
std::vector<Vec2> starts(const Level& level, const Sector& sector, std::size_t loop) {
  std::vector<Vec2> found;
  const auto index = static_cast<std::size_t>(&sector - level.sectors.data());
  for (const Segment& segment : level.segments)
    if (segment.sector.index() == index && segment.loop == loop) found.push_back(segment.p0);
  return found;
}

const TextureMapping& mappingAt(const LoadedLevel& loaded, Vec2 p0) {
  for (const Segment& segment : loaded.level.segments)
    if (segment.p0 == p0) return std::get<Solid>(segment.wall).texture;
  ADD_FAILURE() << "no wall begins at " << p0.x << ", " << p0.y;
  std::abort();
}

TEST(Grid, sectorsAreNamedByTheirEntryAndFirstCell) {
  const LoadedLevel loaded = loadGrid("'######', '#.#..#', '#..s.#', '#.##s#', '######'");
  EXPECT_EQ(sectorNames(loaded.level), (std::vector<std::string>{".1,1", ".3,1", "s3,2", "s4,3"}));
}

TEST(Grid, charactersAreCodePoints) {
  const LoadResult result = loadText(
      "{'light': 1, 'grid': {'rows': ['\xE5\xA2\x99\xE5\xA2\x99\xE5\xA2\x99', "
      "'\xE5\xA2\x99\\ud83d\\ude00\\u5899', '\xE5\xA2\x99\xE5\xA2\x99\xE5\xA2\x99'], 'legend': "
      "{'\\u5899': {'wall': '#808080'}, '\xF0\x9F\x98\x80': {'floor': {'texture': '#404040'}, "
      "'ceiling': {'texture': '#202020'}}}}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.loaded->level.sectors[0].name,
            "\xF0\x9F\x98\x80"
            "1,1");
}

TEST(Grid, cellsLieAtTheirOriginAndSize) {
  const LoadedLevel loaded = loadGrid("'####', '#..#', '####'", "'cell': 2, 'origin': [10, -3], ");
  EXPECT_EQ(starts(loaded.level, loaded.level.sectors[0], 0),
            (std::vector<Vec2>{{12, -1}, {16, -1}, {16, 1}, {12, 1}}));
}

TEST(Grid, theDefaultIsACellOfAMetreAtTheOrigin) {
  const LoadedLevel loaded = loadGrid("'###', '#.#', '###'");
  EXPECT_EQ(starts(loaded.level, loaded.level.sectors[0], 0),
            (std::vector<Vec2>{{1, 1}, {2, 1}, {2, 2}, {1, 2}}));
}

TEST(Grid, airMayBeAllOfARow) {
  // Beside a sector without height a blank shows nothing.
  const LoadResult result = loadText(
      "{'light': 1, 'grid': {'rows': [' .'], 'legend': {'.': {'floor': {'texture': "
      "'#404040'}, 'ceiling': {'z': 0, 'texture': '#202020'}}}}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(starts(result.loaded->level, result.loaded->level.sectors[0], 0).front(), Vec2(1, 0));
}

TEST(Grid, noSectorNeedsToBeWrittenOutBesideIt) {
  for (const std::string sectors : {"{}", "[]"}) {
    const LoadResult result =
        loadText("{'light': 1, 'sectors': " + sectors +
                 ", 'grid': {'rows': ['###', '#.#', '###'], " + std::string(kLegend) + "}}");
    EXPECT_TRUE(result.loaded) << listed(result);
  }
}

TEST(Grid, holesBeginAtTheirFirstCell) {
  const LoadedLevel loaded = loadGrid("'#####', '#...#', '#.#.#', '#...#', '#####'");
  ASSERT_EQ(loaded.level.sectors[0].loops.size(), 2u);
  EXPECT_EQ(loaded.level.sectors[0].loops[1].name, "hole 2,2");
  EXPECT_EQ(starts(loaded.level, loaded.level.sectors[0], 1),
            (std::vector<Vec2>{{2, 2}, {2, 3}, {3, 3}, {3, 2}}));
}

TEST(Grid, solidCellsThatMeetAtACornerHaveALoopEach) {
  const LoadedLevel loaded = loadGrid("'######', '#....#', '#.#..#', '#..#.#', '#....#', '######'");
  ASSERT_EQ(loaded.level.sectors.size(), 1u);
  EXPECT_EQ(loaded.level.sectors[0].loops.size(), 3u);
}

TEST(Grid, airCellsThatMeetAtACornerAreTwoSectors) {
  const LoadedLevel loaded = loadGrid("'####', '#.##', '##.#', '####'");
  EXPECT_EQ(sectorNames(loaded.level), (std::vector<std::string>{".1,1", ".2,2"}));
}

TEST(Grid, imagesRunOnFromCellToCell) {
  const LoadedLevel loaded =
      loadGrid("'#####', '#...#', '#...#', '#####'", "'cell': 2, 'origin': [100, 100], ");
  EXPECT_EQ(mappingAt(loaded, {102, 102}).along, 2);   // eastwards, the cell's x
  EXPECT_EQ(mappingAt(loaded, {108, 102}).along, 2);   // southwards, its y
  EXPECT_EQ(mappingAt(loaded, {108, 106}).along, -8);  // westwards
  EXPECT_EQ(mappingAt(loaded, {102, 106}).along, -6);  // northwards
}

TEST(Grid, sidesOfSolidCellsAreNamedByWhereTheyLook) {
  const LoadResult result = loadText(
      "{'light': 1, 'grid': {'rows': ['###', '#.#', '###'], 'legend': {'#': {'wall': "
      "'#000000', 'walls': {'n': '#000001', 'e': '#000002', 's': '#000003'}}, '.': "
      "{'floor': {'texture': '#404040'}, 'ceiling': {'texture': '#202020'}}}}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  const auto textureAt = [&](Vec2 p0) {
    return result.loaded->level.textures[mappingAt(*result.loaded, p0).texture.index()];
  };
  EXPECT_EQ(textureAt({1, 1}), "#000003");  // of the cell in the north, its southern side
  EXPECT_EQ(textureAt({2, 1}), "#000000");  // in the east, its western side: as "wall" says
  EXPECT_EQ(textureAt({2, 2}), "#000001");
  EXPECT_EQ(textureAt({1, 2}), "#000002");
}

TEST(Grid, stepsWearTheTextureOfTheHigherFloorAndTheLowerCeiling) {
  const LoadedLevel loaded = loadGrid("'####', '#.s#', '####'");
  const Level& level = loaded.level;
  for (const Segment& segment : level.segments) {
    const Portal* portal = std::get_if<Portal>(&segment.wall);
    if (!portal) continue;
    const bool isSeenFromLowFloor = level[segment.sector].name == ".1,1";
    ASSERT_EQ(portal->lower.has_value(), isSeenFromLowFloor);
    ASSERT_EQ(portal->upper.has_value(), isSeenFromLowFloor);
    if (!isSeenFromLowFloor) continue;
    EXPECT_EQ(level.textures[portal->lower->texture.index()], "#00aa00");
    EXPECT_EQ(level.textures[portal->upper->texture.index()], "#aa0000");
  }
  EXPECT_EQ(sectorNamed(level, "s2,1").light, 0.25);
  EXPECT_EQ(sectorNamed(level, ".1,1").light, 0.5);
}

TEST(Grid, aSectorThatIsWrittenOutJoinsByNext) {
  const LoadResult result = loadText(
      "{'light': 1, 'sectors': {'hall': {'floor': {'z': 0.2, 'texture': '#404040'}, 'ceiling': "
      "{'texture': '#202020'}, 'loops': {'border': {'v': [2,1, 6,1, 6,2, 2,2], 'walls': "
      "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, {'next': '.1,1', "
      "'upper': '#808080'}]}}}}, 'grid': {'rows': ['####', '#.h#', '####'], 'legend': {'#': "
      "{'wall': '#808080'}, 'h': {'next': 'hall', 'lower': '#0000aa'}, '.': {'floor': {'texture': "
      "'#404040'}, 'ceiling': {'z': 3, 'texture': '#202020'}}}}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  expectTwins(result.loaded->scene());
  EXPECT_EQ(sectorNames(result.loaded->level), (std::vector<std::string>{"hall", ".1,1"}));
}

TEST(Grid, moreCellsThanTheLimitAreRefused) {
  LoadLimits limits;
  limits.gridCells = 11;
  const std::string text =
      "{'light': 1, 'grid': {'rows': ['####', '#..#', '####'], " + std::string(kLegend) + "}}";
  const LoadResult result = loadText(text, "", limits);
  EXPECT_EQ(result.diagnostics[0].message, "more than 11 cells");
  EXPECT_EQ(result.diagnostics[0].advice, "raise the limit with --max-grid-cells");
  EXPECT_EQ(result.diagnostics[0].pointer, "/grid/rows/2");
  limits.gridCells = 12;
  EXPECT_TRUE(loadText(text, "", limits).loaded);
  limits.vertices = 3;
  EXPECT_EQ(loadText(text, "", limits).diagnostics[0].message, "more than 3 vertices");
}

}  // namespace
}  // namespace hearth
