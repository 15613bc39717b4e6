#include "load/source.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "support/temporary_folder.h"

namespace hearth {

namespace {

/// The text of a file from a place on.
std::string_view at(const LevelSource& source, Place place) {
  return std::string_view(source.documents[place.document].text).substr(place.offset);
}

/// Two rooms, the first one's border and pillar being written the wrong way round.
constexpr std::string_view kLevel = R"({ "light": 0.5, "sectors": {
  "a": { "floor": {"texture": "#808080"}, "ceiling": {"texture": "#808080"}, "loops": {
    "pillar": { "v": [1,1, 2,1, 2,2, 1,2], "walls": {"texture": "#102030"} },
    "border": { "v": [0,4, 4,4, 4,2, 4,0, 0,0], "walls": [
      {"texture": "#000000"}, {"next": "b"}, {"texture": "#000002"}, {"texture": "#000003"},
      {"texture": "#000004"}] } } },
  "b": { "floor": {"texture": "#808080"}, "ceiling": {"texture": "#808080"}, "loops": {
    "border": { "v": [4,2, 6,2, 6,4, 4,4, 4,3], "walls": [
      {"texture": "#010000"}, {"texture": "#010001"}, {"texture": "#010002"}, {"next": "a"},
      {"next": "a"}] } } }
} })";

SourcedResult loadSource() {
  const test::TemporaryFolder folder;
  folder.write("level.lights.json", R"([ {"x": 1, "y": 3, "z": 1}, {"x": 5, "y": 3, "z": 1} ])");
  return loadLevelWithSource(folder.write("level.json", kLevel));
}

TEST(LevelSource, hasTheAuthoredWallOfEachSegment) {
  const SourcedResult sourced = loadSource();
  ASSERT_TRUE(sourced.result.loaded);
  const Level& level = sourced.result.loaded->level;
  int portals = 0;
  for (std::size_t i = 0; i < level.segments.size(); ++i) {
    const std::string_view text = at(sourced.source, sourced.source.wall(SegmentId(i)).place);
    if (const Solid* solid = std::get_if<Solid>(&level.segments[i].wall)) {
      EXPECT_TRUE(text.starts_with("{\"texture\": \"" +
                                   level.textures[solid->texture.texture.index()] + "\"}"))
          << text;
      continue;
    }
    ++portals;
    const bool isFirst = level[level.segments[i].sector].name == "a";
    EXPECT_TRUE(text.starts_with(isFirst ? "{\"next\": \"b\"}" : "{\"next\": \"a\"}")) << text;
  }
  EXPECT_EQ(portals, 4);  // the one of "a" is cut where "b" has a vertex
}

TEST(LevelSource, hasThePlacesOfVerticesOfLoopsThatWereTurnedRound) {
  const SourcedResult sourced = loadSource();
  const LevelSource& source = sourced.source;
  for (const Edge& edge : source.outlines.edges)
    for (const std::uint32_t vertex : {edge.from, edge.to}) {
      const std::string_view text = at(source, source.vertexPlace(edge, vertex));
      const Vec2 p = source.outlines.points[vertex];
      const std::string written =
          std::to_string(static_cast<int>(p.x)) + "," + std::to_string(static_cast<int>(p.y));
      EXPECT_TRUE(text.starts_with(written)) << written << " is not " << text.substr(0, 10);
    }
}

TEST(LevelSource, hasSectorsAndLightsInTheOrderOfTheLevel) {
  const SourcedResult sourced = loadSource();
  EXPECT_TRUE(at(sourced.source, sourced.source.level.sectors[1].place).starts_with("\"b\": {"));
  EXPECT_TRUE(at(sourced.source, sourced.source.lights.lights[1].place).starts_with("{\"x\": 5"));
}

TEST(LevelSource, tellsTheSameAsLoadingAlone) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("level.json", R"({ "sectors": {}, "colour": 1 })");
  const SourcedResult sourced = loadLevelWithSource(file);
  EXPECT_FALSE(sourced.result.loaded);
  EXPECT_EQ(sourced.result.diagnostics, loadLevel(file).diagnostics);
  EXPECT_FALSE(sourced.result.diagnostics.empty());
}

}  // namespace

}  // namespace hearth
