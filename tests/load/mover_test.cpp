#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "load/source.h"
#include "load_text.h"
#include "support/temporary_folder.h"

/// What movers become, and what a level becomes that they have moved. What is wrong with some is
/// told in bad/.
namespace hearth {
namespace {

const std::string kHall = "0,0, 4,0, 4,4, 0,4";
const std::string kDoor = "4,0, 5,0, 5,4, 4,4";
const std::string kYard = "5,0, 9,0, 9,4, 5,4";

/// A hall and a yard, and between them a door that is shut.
const std::string kHallWalls =
    "[{'texture': '#808080'}, {'next': 'door', 'texture': '#604020'}, {'texture': '#808080'},"
    " {'texture': '#808080'}]";
std::string sectorsText(const std::string& hallWalls) {
  const std::string to = "{{'next': '{}', 'texture': '#604020'}}";
  const std::string solid = "{'texture': '#808080'}";
  const auto to_ = [&](std::string_view next) { return fmt::format(fmt::runtime(to), next); };
  return sectorText("hall", kHall, hallWalls) + "," +
         sectorText("door", kDoor,
                    fmt::format("[{0}, {1}, {0}, {2}]", solid, to_("yard"), to_("hall")),
                    "'ceiling': {'z': 0, 'texture': '#404040'}") +
         "," + sectorText("yard", kYard, fmt::format("[{0}, {0}, {0}, {1}]", solid, to_("door")));
}

class LoadedMovers : public testing::Test {
 protected:
  SourcedResult load(std::string_view movers, std::string_view more = "") {
    return loadText(movers, more, sectorsText(kHallWalls));
  }
  /// With other walls of the hall.
  SourcedResult loadHall(std::string_view movers, const std::string& walls) {
    return loadText(movers, "", sectorsText(walls));
  }

  static LoadedLevel at(const SourcedResult& loaded, std::vector<double> shares) {
    LoadResult result = levelAt(*loaded.result.loaded, loaded.source, shares);
    EXPECT_TRUE(result.loaded) << listed(result);
    return *std::move(result.loaded);
  }

 private:
  SourcedResult loadText(std::string_view movers, std::string_view more,
                         const std::string& sectors) {
    std::string text = fmt::format("{{'light': 0.5, 'movers': {{{}}}, {} 'sectors': {{{}}}}}",
                                   movers, more, sectors);
    std::ranges::replace(text, '\'', '"');
    SourcedResult loaded = loadLevelWithSource(folder_.write("level.json", text));
    EXPECT_TRUE(loaded.result.loaded) << listed(loaded.result);
    return loaded;
  }

  test::TemporaryFolder folder_;
};

TEST_F(LoadedMovers, takeDefaultsForAllButWhatMovesWhere) {
  const auto loaded = load("'gate': {'sectors': 'door', 'part': 'ceiling', 'to': 2.5}");
  ASSERT_EQ(loaded.result.loaded->level.movers.size(), 1U);
  const Mover& gate = loaded.result.loaded->level.movers[0];
  EXPECT_EQ(gate.name, "gate");
  EXPECT_EQ(gate.sectors, std::vector{SectorId(1)});
  EXPECT_EQ(gate.part, FlatPart::Ceiling);
  EXPECT_EQ(gate.to, 2.5);
  EXPECT_EQ(gate.speed, 1.5);
  EXPECT_FALSE(gate.wait);
  EXPECT_EQ(gate.trigger, MoverTrigger::None);
  EXPECT_TRUE(gate.zones.empty());
}

TEST_F(LoadedMovers, takeEveryKey) {
  const auto loaded = load(
      "'lift': {'sectors': ['hall', 'yard'], 'part': 'floor', 'to': -1, 'speed': 0.5, 'wait': 4,"
      " 'trigger': 'enter', 'zones': ['yard', 'hall']}");
  const Mover& lift = loaded.result.loaded->level.movers.at(0);
  EXPECT_EQ(lift.sectors, (std::vector{SectorId(0), SectorId(2)}));
  EXPECT_EQ(lift.part, FlatPart::Floor);
  EXPECT_EQ(lift.to, -1);
  EXPECT_EQ(lift.speed, 0.5);
  EXPECT_EQ(lift.wait, 4);
  EXPECT_EQ(lift.trigger, MoverTrigger::Enter);
  EXPECT_EQ(lift.zones, (std::vector{SectorId(2), SectorId(0)}));
}

TEST_F(LoadedMovers, haveTheirSharesInShots) {
  const auto loaded =
      load("'gate': {'sectors': ['door'], 'part': 'ceiling', 'to': 2.5}",
           "'shots': [{'name': 'ajar', 'camera': [1, 2, 1, 0, 0], 'movers': {'gate': 0.25}}],");
  EXPECT_EQ(loaded.result.loaded->level.shots.at(0).movers, (std::vector{MoverShare{0, 0.25}}));
}

/// The names of the textures that the walls of the hall show, each once.
std::set<std::string> shownInHall(const LoadedLevel& loaded) {
  std::set<std::string> names;
  for (const Surface& surface : loaded.level.surfaces)
    if (surface.segment && surface.sector == SectorId(0))
      names.insert(loaded.level.textures[surface.mapping.texture.index()]);
  return names;
}

TEST_F(LoadedMovers, changeTheTexturesOfSwitchesThatStartThem) {
  const std::string lever =
      "{'texture': '#808080', 'use': ['gate', 'lift'], 'on': {'#808080': '#ff0000'}}";
  const std::string stack =
      "{'walls': [{'z': 1, 'texture': '#101010', 'use': 'lift', 'on': {'#101010': '#202020'}},"
      " {'texture': '#303030'}]}";
  const std::string solid = "{'texture': '#404040'}";
  const auto loaded = loadHall(
      "'gate': {'sectors': ['door'], 'part': 'ceiling', 'to': 2.5},"
      "'lift': {'sectors': ['yard'], 'part': 'floor', 'to': 1}",
      fmt::format("[{}, {{'next': 'door', 'texture': '#604020'}}, {}, {}]", lever, stack, solid));
  using Names = std::set<std::string>;
  const Names off{"#808080", "#604020", "#101010", "#303030", "#404040"};
  EXPECT_EQ(shownInHall(*loaded.result.loaded), off);
  EXPECT_EQ(shownInHall(at(loaded, {0, 0})), off);
  EXPECT_EQ(shownInHall(at(loaded, {0.1, 0})),
            (Names{"#ff0000", "#604020", "#101010", "#303030", "#404040"}));
  EXPECT_EQ(shownInHall(at(loaded, {0, 1})),
            (Names{"#ff0000", "#604020", "#202020", "#303030", "#404040"}));
  const LoadedLevel moved = at(loaded, {1, 1});
  for (const SurfaceId id : moved.scene().shownSurfaces())
    EXPECT_NE(moved.textures[moved.level[id].mapping.texture.index()].at(0, 0), (Rgb{}));
}

TEST_F(LoadedMovers, standWhereTheirSharesTakeThem) {
  const auto loaded = load("'gate': {'sectors': ['door'], 'part': 'ceiling', 'to': 2.5}");
  for (const double share : {0.0, 0.5, 1.0}) {
    const LoadedLevel moved = at(loaded, {share});
    EXPECT_EQ(moved.level.sectors[1].ceiling.z, 2.5 * share);
    EXPECT_EQ(moved.geometry.sectors[1].zCeiling, 2.5 * share);
    EXPECT_EQ(moved.level.sectors[0].ceiling.z, 4);
    EXPECT_TRUE(moved.textures.sharesWith(loaded.result.loaded->textures));
  }
}

TEST_F(LoadedMovers, carryThingsWithoutAHeightAndLeaveTheOthers) {
  const auto loaded = load("'lift': {'sectors': ['yard'], 'part': 'floor', 'to': 1}",
                           "'things': [{'sprite': '#ff0000', 'x': 7, 'y': 2},"
                           " {'sprite': '#00ff00', 'x': 7, 'y': 2, 'z': 2}],");
  const LoadedLevel moved = at(loaded, {0.5});
  EXPECT_EQ(moved.level.sprites[0].position, (Vec3{7, 2, 0.5}));
  EXPECT_EQ(moved.level.sprites[1].position, (Vec3{7, 2, 2}));
}

TEST_F(LoadedMovers, leaveThePlayerOutWhereTheyTakeItsAir) {
  const auto loaded = load("'lift': {'sectors': ['yard'], 'part': 'floor', 'to': 3}",
                           "'player': {'x': 7, 'y': 2, 'z': 1.6},");
  EXPECT_TRUE(at(loaded, {0}).level.player);
  EXPECT_TRUE(at(loaded, {0.5}).level.player) << "its eye is 10 cm above the floor";
  EXPECT_FALSE(at(loaded, {1}).level.player);
}

TEST_F(LoadedMovers, haveTheImagesOfStepsThatShowOnlyAtTheirOtherEnd) {
  const auto loaded = load(
      "'lift': {'sectors': ['yard'], 'part': 'floor', 'to': 1},"
      "'gate': {'sectors': ['door'], 'part': 'ceiling', 'to': 2.5}");
  const LoadedLevel moved = at(loaded, {1, 1});
  for (const SurfaceId id : moved.scene().shownSurfaces()) {
    const Image& image = moved.textures[moved.level[id].mapping.texture.index()];
    EXPECT_NE(image.at(0, 0), (Rgb{})) << name(moved.level[id].kind);
  }
}

}  // namespace
}  // namespace hearth
