#include <gtest/gtest.h>

#include "load_text.h"
#include "support/in_tree.h"

/// What levels that follow the rules become.
namespace hearth {
namespace {

const std::string kRoom = "0,0, 4,0, 4,4, 0,4";

TEST(Level, takesSectorsAndLoopsAsObjectsOrAsArrays) {
  const std::string walls = "'walls': {'texture': '#808080'}";
  const std::string flats =
      "'floor': {'texture': '#111111'}, 'ceiling': {'texture': '#222222'}, 'loops': ";
  const LoadResult asObjects =
      loadText("{'light': 1, 'sectors': {'a': {" + flats + "{'hole': {'v': [1,1, 1,2, 2,2], " +
               walls + "}, 'border': {'v': [" + kRoom + "], " + walls + "}}}}}");
  const LoadResult asArrays =
      loadText("{'light': 1, 'sectors': [{'name': 'a', " + flats +
               "[{'name': 'hole', 'v': [1,1, 1,2, 2,2], " + walls + "}, {'name': 'border', 'v': [" +
               kRoom + "], " + walls + "}]}]}");
  for (const LoadResult* result : {&asObjects, &asArrays}) {
    ASSERT_TRUE(result->loaded) << listed(*result);
    const Sector& sector = sectorNamed(result->loaded->level, "a");
    ASSERT_EQ(sector.loops.size(), 2U);
    EXPECT_EQ(sector.loops[0].name, "border");
    EXPECT_EQ(sector.loops[0].count, 4U);
    EXPECT_EQ(sector.loops[1].name, "hole");
    EXPECT_EQ(sector.loops[1].first, SegmentId(4));
    EXPECT_EQ(sector.segmentCount, 7U);
  }
}

TEST(Level, ignoresCommentKeysEverywhere) {
  const LoadResult result = loadText(
      "{'$schema': 1, '//': 'a', '//': 'b', 'light': 1, 'sectors': {'// c': 3, " +
      sectorText("a", kRoom, "{'texture': {'name': '#808080', '//': 0}, '//': []}", "'//': null") +
      "}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.loaded->level.sectors.size(), 1U);
}

TEST(Level, takesTheOnlyLoopForTheBorderWhateverItsName) {
  const LoadResult result = loadText(
      "{'light': 1, 'sectors': {'a': {'floor': {'texture': '#111111'}, 'ceiling': {'texture': "
      "'#222222'}, 'loops': {'rim': {'v': [" +
      kRoom + "], 'walls': {'texture': '#808080'}}}}}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.loaded->level.sectors[0].loops[0].name, "rim");
}

TEST(Level, takesItsNameFromItsFileWhenItGivesNone) {
  EXPECT_EQ(loadSectors(sectorText("a", kRoom)).level.name, "level");
}

TEST(Level, givesFlatsTheirDefaultHeights) {
  const Level level = loadSectors(sectorText("a", kRoom)).level;
  EXPECT_EQ(level.sectors[0].floor.z, 0);
  EXPECT_EQ(level.sectors[0].ceiling.z, 4);
}

TEST(Level, turnsALoopRoundByTheEndsOfItsWallsAlone) {
  const std::string walls =
      "[{'texture': '#000001'}, {'texture': '#000002'}, {'texture': '#000003'}, "
      "{'texture': '#000004'}]";
  const LoadResult result = loadText("{'light': 1, 'sectors': {" +
                                     sectorText("a", "0,0, 0,4, 5,4, 5,0", walls,
                                                "'floor': {'texture': '#000005', 'isRelative': "
                                                "true}") +
                                     "}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(countWarnings(result), 1U);
  const Level& level = result.loaded->level;
  const Vec2 expected[] = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(level.segments[i].p0, expected[i]);
    EXPECT_EQ(level.segments[i].p1, expected[(i + 1) % 4]);
    EXPECT_EQ(level.segments[i].wallIndex, 3 - i);
    const TextureId texture = std::get<Solid>(level.segments[i].wall).texture.texture;
    EXPECT_EQ(level.textures[texture.index()], "#00000" + std::to_string(4 - i));
  }
  EXPECT_EQ(level.sectors[0].floor.textureOrigin, (Vec2{0, 0}));
}

TEST(Level, matchesSlopeHeightsToVerticesOfATurnedLoopInFileOrder) {
  const Level level = loadSectors(sectorText("a", "0,0, 0,4, 4,4, 4,0", "{'texture': '#808080'}",
                                             "'slopeFloor': {'z': [0, 1, 1, 0]}"))
                          .level;
  EXPECT_EQ(level.sectors[0].floorSlope.value().gradient, (Vec2{0, 0.25}));
}

TEST(Level, letsHolesTouchTheBorderAndEachOther) {
  const LoadResult result = loadText(
      "{'light': 1, 'sectors': {'a': {'floor': {'texture': '#111111'}, 'ceiling': {'texture': "
      "'#222222'}, 'loops': {'border': {'v': [" +
      kRoom +
      "], 'walls': {'texture': '#808080'}},"
      "'corner': {'v': [0,0, 1,2, 2,1], 'walls': {'texture': '#808080'}},"
      "'wall': {'v': [4,1, 3,1, 3,2, 4,2], 'walls': {'texture': '#808080'}},"
      "'next': {'v': [3,1, 2,1, 2,2, 3,2], 'walls': {'texture': '#808080'}}}}}}");
  EXPECT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.diagnostics.size(), 0U) << listed(result);
}

TEST(Level, acceptsAClosedDoorWithItsTexture) {
  const std::string room =
      sectorText("a", kRoom,
                 "[{'texture': '#808080'}, {'next': 'door', 'upper': '#112233'}, "
                 "{'texture': '#808080'}, {'texture': '#808080'}]");
  const std::string door = sectorText(
      "door", "4,0, 5,0, 5,4, 4,4",
      "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, {'next': 'a'}]",
      "'ceiling': {'z': 0, 'texture': '#404040'}");
  const LoadResult result = loadText("{'light': 1, 'sectors': {" + room + "," + door + "}}");
  EXPECT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.diagnostics.size(), 0U) << listed(result);
}

TEST(Level, needsNoTextureForAStepBetweenTwoSkies) {
  const std::string sky = "'ceiling': {'z': 4, 'texture': '#8080ff', 'parallax': true}";
  const std::string lowSky = "'ceiling': {'z': 3, 'texture': '#8080ff', 'parallax': true}";
  const LoadResult result = loadText(
      "{'light': 1, 'sectors': {" +
      sectorText("a", kRoom,
                 "[{'texture': '#808080'}, {'next': 'b'}, {'texture': '#808080'}, "
                 "{'texture': '#808080'}]",
                 sky) +
      "," +
      sectorText("b", "4,0, 8,0, 8,4, 4,4",
                 "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, "
                 "{'next': 'a'}]",
                 lowSky) +
      "}}");
  EXPECT_TRUE(result.loaded) << listed(result);
}

TEST(Level, measuresSubWallsFromTheSectorsFloor) {
  const Level level =
      loadSectors(sectorText("a", kRoom,
                             "{'walls': [{'z': 1.5, 'texture': '#000001'}, {'texture': "
                             "'#000002'}]}",
                             "'floor': {'z': 10, 'texture': '#111111'}, 'ceiling': {'z': 13, "
                             "'texture': '#111111'}"))
          .level;
  const Stack& stack = std::get<Stack>(level.segments[0].wall);
  const Sector& sector = level.sectors[0];
  EXPECT_EQ(stack.topOf(0, sector.floor.z, sector.ceiling.z), 11.5);
  EXPECT_EQ(stack.topOf(1, sector.floor.z, sector.ceiling.z), 13);
}

TEST(Level, needsNoTextureForAStepThatIsRoundingAlone) {
  // -2.5 + 2.8 and 4.3 - 2.6 are not 0.3 and 1.7 to the bit.
  const LoadResult result = loadText(
      "{'light': 1, 'sectors': {" +
      sectorText("a", kRoom,
                 "[{'walls': [{'texture': '#808080', 'z': 2.8}, {'next': 'b', 'z': 4.2},"
                 " {'texture': '#808080'}]}, {'texture': '#808080'}, {'texture': '#808080'},"
                 " {'texture': '#808080'}]",
                 "'floor': {'z': -2.5, 'texture': '#808080'},"
                 "'ceiling': {'z': 4, 'texture': '#808080'}") +
      "," +
      sectorText("b", "0,-4, 4,-4, 4,0, 0,0",
                 "[{'texture': '#808080'}, {'texture': '#808080'}, {'next': 'a'},"
                 " {'texture': '#808080'}]",
                 "'floor': {'z': 0.3, 'texture': '#808080'},"
                 "'ceiling': {'z': 1.7, 'texture': '#808080'}") +
      "}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_NE(-2.5 + 2.8, 0.3);
  EXPECT_NE(-2.5 + 4.2, 1.7);
  for (const Segment& segment : result.loaded->level.segments) {
    const std::span<const WallPiece> pieces = result.loaded->scene().piecesOf(segment);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
      EXPECT_EQ(pieces[i].zTop, pieces[i + 1].zBottom);
  }
}

TEST(Level, joinsFlatsOfBothSpellingsIntoOneInterface) {
  const std::string ceiling = "'ceiling': {'z': 8, 'texture': '#404040'}";
  const Level level =
      loadSectors(
          sectorText("up", "0,0, 2,0, 2,4, 0,4", "{'texture': '#808080'}",
                     "'floor': {'z': 4, 'next': 'up-down'}, " + ceiling) +
          "," +
          sectorText("more", "2,0, 4,0, 4,4, 2,4", "{'texture': '#808080'}",
                     "'floor': {'z': 4, 'next': {'up': 'up', 'down': 'down'}}, " + ceiling) +
          "," +
          sectorText("down", kRoom, "{'texture': '#808080'}",
                     "'ceiling': {'z': 4, 'next': 'up-down'}"))
          .level;
  ASSERT_EQ(level.flatPortals.size(), 1U);
  EXPECT_EQ(level.flatPortals[0].upper, (std::vector{SectorId(0), SectorId(1)}));
  EXPECT_EQ(level.flatPortals[0].lower, (std::vector{SectorId(2)}));
  EXPECT_FALSE(level.sectors[2].ceilingSurface);
}

TEST(Level, letsSectorsAboveAFlatPortalTouchInAPoint) {
  // A corner of the one lies in the middle of a wall of the other, apart from rounding.
  const std::string large = "2.067,10.239, 0.839,10.145, 0.642,9.334, 2.192,9.46";
  const std::string small = "0.04,9.776, 0.164,9.5, 0.7405,9.7395, 0.3,10.06";
  const std::string above =
      "'floor': {'z': 4, 'next': 'up-down'}, 'ceiling': {'z': 8, 'texture': "
      "'#404040'}";
  const std::string below = "'ceiling': {'z': 4, 'next': 'up-down'}";
  const std::string wall = "{'texture': '#808080'}";
  const LoadResult result = loadText(
      "{'light': 1, 'sectors': {" + sectorText("up", large, wall, above) + "," +
      sectorText("up2", small, wall, above) + "," + sectorText("down", large, wall, below) + "," +
      sectorText("down2", small, wall, below) + "}}");
  EXPECT_TRUE(result.loaded) << listed(result);
}

TEST(Level, takesNamesWithADashInTheObjectFormOfNext) {
  const Level level =
      loadSectors(sectorText("a-b", kRoom, "{'texture': '#808080'}",
                             "'floor': {'z': 4, 'next': {'up': 'a-b', 'down': 'c-'}}, 'ceiling': "
                             "{'z': 8, 'texture': '#404040'}") +
                  "," +
                  sectorText("c-", kRoom, "{'texture': '#808080'}",
                             "'ceiling': {'z': 4, 'next': {'up': 'a-b', 'down': 'c-'}}"))
          .level;
  EXPECT_EQ(level.flatPortals.size(), 1U);
}

TEST(Level, fillsUnknownHeightsOfASlopeFromThePlaneOfTheOthers) {
  const Level level = loadSectors(sectorText("a", "1,1, 5,1, 5,5, 1,5", "{'texture': '#808080'}",
                                             "'slopeCeil': {'z': [0, 2, null, 0]}"))
                          .level;
  const Slope& slope = level.sectors[0].ceilingSlope.value();
  EXPECT_EQ(slope.origin, (Vec2{1, 1}));
  EXPECT_EQ(slope.zAt({1, 1}), 4);
  EXPECT_EQ(slope.zAt({5, 5}), 2);
  EXPECT_EQ(level.sectors[0].ceiling.textureOrigin, (Vec2{1, 1}));
}

TEST(Level, keepsAWedgeOnItsFlatWhereNoiseWouldTakeItPast) {
  const LoadedLevel loaded =
      loadSectors(sectorText("a", "1,12, 1,7, 5,7, 5,12", "{'texture': '#808080'}",
                             "'slopeFloor': {'z': [0, 0.5, 0.4998, null]}, "
                             "'slopeCeil': {'z': [0, 0.5, 0.4998, null]}"));
  const Level& level = loaded.level;
  EXPECT_NEAR(level.sectors[0].floorSlope.value().zAt({5, 12}), 0, 1e-12);
  EXPECT_NEAR(level.sectors[0].floorSlope.value().zAt({1, 12}), 0.0002, 1e-12);
  EXPECT_NEAR(level.sectors[0].ceilingSlope.value().zAt({5, 12}), 4, 1e-12);
  for (const Segment& segment : level.segments) {
    const SegmentGeometry& at = loaded.scene().geometryOf(segment);
    EXPECT_GE(at.air0.zBottom, 0);
    EXPECT_GE(at.air1.zBottom, 0);
    EXPECT_LE(at.air0.zTop, 4);
    EXPECT_LE(at.air1.zTop, 4);
  }
}

TEST(Level, letsAWedgeTouchTheCeiling) {
  const LoadResult result = loadText(
      "{'light': 1, 'sectors': {" +
      sectorText("a", kRoom, "{'texture': '#808080'}", "'slopeFloor': {'z': [0, 4, 4, 0]}") + "}}");
  EXPECT_TRUE(result.loaded) << listed(result);
}

TEST(Level, takesSlopeHeightsThatMissAPlaneByHalfAMillimetre) {
  EXPECT_TRUE(loadText("{'light': 1, 'sectors': {" +
                       sectorText("a", kRoom, "{'texture': '#808080'}",
                                  "'slopeFloor': {'z': [0, 1, 1.0005, 0]}") +
                       "}}")
                  .loaded);
}

TEST(Level, readsThePlayersBodyAndTheShots) {
  const LoadResult result = loadText(
      "{'light': 1, 'player': {'x': 1, 'y': 2, 'z': 1.5, 'angle': 45, 'height': 2, 'eye': 1.7, "
      "'radius': 0.2, 'step': 0.5}, 'shots': [{'name': 's', 'camera': [3, 2, 1, 90, -30], 'fov': "
      "60, 'size': [64, 48], 'sector': 'a'}, {'name': 't', 'camera': [0, 0, 0, 0, 0]}], "
      "'sectors': {" +
      sectorText("a", kRoom) + "}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  const Player& player = result.loaded->level.player.value();
  EXPECT_EQ(player.eye, (Vec3{1, 2, 1.5}));
  EXPECT_EQ(player.angle, 45);
  EXPECT_EQ(player.height, 2);
  EXPECT_EQ(player.eyeHeight, 1.7);
  EXPECT_EQ(player.radius, 0.2);
  EXPECT_EQ(player.stepHeight, 0.5);
  const std::vector<Shot>& shots = result.loaded->level.shots;
  ASSERT_EQ(shots.size(), 2U);
  EXPECT_EQ(shots[0].eye, (Vec3{3, 2, 1}));
  EXPECT_EQ(shots[0].angle, 90);
  EXPECT_EQ(shots[0].pitch, -30);
  EXPECT_EQ(shots[0].fov, 60);
  EXPECT_EQ(shots[0].width, 64);
  EXPECT_EQ(shots[0].height, 48);
  EXPECT_EQ(shots[1].fov, 90);
  EXPECT_EQ(shots[1].width, 320);
  EXPECT_EQ(shots[1].height, 200);
}

TEST(Level, loadsTheTutorial) {
  const LoadResult result = loadLevel(test::inTree("levels/tutorial.json"));
  ASSERT_TRUE(result.loaded) << listed(result);
  expectTwins(result.loaded->scene());
  EXPECT_EQ(result.loaded->textures.size(), result.loaded->level.textures.size());
  EXPECT_EQ(result.loaded->files[1].filename(), "tutorial.lights.json");
}

}  // namespace
}  // namespace hearth
