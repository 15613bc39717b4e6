// What moves in imported maps, once their level is loaded.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "import/doom/import_map.h"
#include "load/load.h"
#include "map_builder.h"
#include "map_lumps.h"
#include "pictures_builder.h"
#include "walk/moving_level.h"
#include "walk/recording.h"

namespace hearth::doom {
namespace {

namespace fs = std::filesystem;

constexpr std::uint16_t kTag = 7;
constexpr int kRoom = 128;  // map units that each of three sectors is long and broad

/// A hall, a sector that moves and a chamber, in a row to the east. The lines between them are 6
/// and 7; both have the middle one to their left.
class ImportedMovers : public testing::Test, protected MapBuilder {
 protected:
  ImportedMovers() {
    for (const int x : {0, kRoom, 2 * kRoom}) {
      const auto here = sector();
      line({x + kRoom, 0}, {x, 0}, here);
      line({x, kRoom}, {x + kRoom, kRoom}, here);
    }
    line({kRoom, kRoom}, {kRoom, 0}, 0, 1);
    line({2 * kRoom, 0}, {2 * kRoom, kRoom}, 2, 1);
    line({0, 0}, {0, kRoom}, 0);
    line({3 * kRoom, kRoom}, {3 * kRoom, 0}, 2);
    map.sectors[1].tag = kTag;
    map.things.push_back({kRoom / 2, kRoom / 2, 0, 1, 7});
    wad_.add("PLAYPAL", palette()).add("PNAMES", patchNames({"PATCH"}));
    std::vector<std::string> textures;
    for (const char* name : {"UPPER", "LOWER", "WALL", "GRATE", "SW1WALL", "SW2WALL", "SW1ODD"})
      textures.push_back(definition(name, 64, 128, {{0, 0, 0}}));
    wad_.add("TEXTURE1", texturesOf(textures)).add("PATCH", plainPatch(64, 128, 9));
    wad_.add("F_START").add("FLOOR", flatOf(1)).add("CEIL", flatOf(2)).add("F_END");
    wad_.add("S_START").add("GOR2A0", plainPatch(8, 8, 1, {4, 8})).add("S_END");
    settings_.folder = folder_;
    fs::remove_all(folder_);
  }
  ~ImportedMovers() override { fs::remove_all(folder_); }

  void setSpecial(std::size_t line, std::uint16_t special, std::uint16_t tag = kTag) {
    map.lines[line].special = special;
    map.lines[line].tag = tag;
  }

  const LoadedLevel& load() {
    addMap(wad_, map);
    const Wad wad = opened(wad_);
    auto imported = importMap({wad, *Pictures::read(wad), lights_}, "MAP01", settings_);
    EXPECT_TRUE(imported) << imported.error();
    imported_ = *std::move(imported);
    loaded_ = loadLevel(imported_.level).loaded;
    EXPECT_TRUE(loaded_);
    return *loaded_;
  }

  /// Where the player is who walks eastwards for some seconds, and presses the use key first.
  Walker walkedEast(double seconds) {
    const Player& player = loaded_->level.player.value();
    MovingLevel moving(loaded_->scene());
    const RecordedStart start{loaded_->level[player.sector].name, player.eye, player.angle, 0};
    Walker walker = walkerAtStart(loaded_->scene(), start).value();
    for (int i = 0; i < seconds * kTicksPerSecond; ++i)
      walker = moving.ticked(walker, {.forward = 127, .use = i % kTicksPerSecond == 0});
    return walker;
  }

  std::string sectorNameOf(const Walker& walker) const {
    return loaded_->level[walker.sector].name;
  }

  bool hasFinding(Part part, std::size_t number) const {
    return std::ranges::any_of(imported_.findings, [&](const Finding& finding) {
      return finding.part == part && finding.number == number;
    });
  }

  WadBuilder wad_;
  LightTable lights_;
  ImportSettings settings_;
  Imported imported_;
  fs::path folder_ = fs::path(testing::TempDir()) / fmt::format("hearth-movers-{}", ::getpid());
  std::optional<LoadedLevel> loaded_;
};

TEST_F(ImportedMovers, areDoorsThatOneWalksThrough) {
  map.sectors[1].ceiling = 0;
  setSpecial(6, 1, 0);
  const Level& level = load().level;
  ASSERT_EQ(level.movers.size(), 1U);
  EXPECT_EQ(level.movers[0].to, 124 / 32.0);
  EXPECT_EQ(level.movers[0].speed, 2.1875);
  EXPECT_NEAR(level.movers[0].wait.value(), 150 / 35.0, 5e-4);
  EXPECT_EQ(level.movers[0].trigger, MoverTrigger::None);
  ASSERT_EQ(level.switches.size(), 1U) << "its other side is no front of a line that opens";
  EXPECT_FALSE(level.switches[0].isCrossed);
  EXPECT_EQ(sectorNameOf(walkedEast(8)), "2");
  EXPECT_EQ(imported_.movers, 1U);
}

TEST_F(ImportedMovers, changeTheTextureOfASwitchWhileItIsOn) {
  map.sectors[1].ceiling = 0;
  setSpecial(0, 103);
  map.sides[map.lines[0].sides[0].value()].middle = "SW1WALL";
  const Level& level = load().level;
  ASSERT_EQ(level.switchTextures.size(), 1U);
  EXPECT_EQ(level.textures[level.switchTextures[0].off.index()], "wall-sw1wall");
  EXPECT_EQ(level.textures[level.switchTextures[0].on.index()], "wall-sw2wall");
}

TEST_F(ImportedMovers, leaveATextureWithoutItsPairAsItIs) {
  map.sectors[1].ceiling = 0;
  setSpecial(0, 103);
  map.sides[map.lines[0].sides[0].value()].middle = "SW1ODD";
  EXPECT_EQ(load().level.switches.size(), 1U);
  EXPECT_TRUE(loaded_->level.switchTextures.empty());
}

TEST_F(ImportedMovers, areStartedByWhoCrossesALineFromEitherSide) {
  map.sectors[2].ceiling = 0;
  map.sectors[2].tag = kTag;
  map.sectors[1].tag = 0;
  setSpecial(6, 2);
  const Level& level = load().level;
  EXPECT_EQ(level.switches.size(), 2U);
  EXPECT_TRUE(level.switches[0].isCrossed);
  EXPECT_EQ(sectorNameOf(walkedEast(8)), "2");
}

TEST_F(ImportedMovers, areStartedByLinesWithinASector) {
  line({kRoom + 64, kRoom}, {kRoom + 64, 0}, 1, 1);
  map.lines[2].to = map.lines.back().to;
  map.lines[3].to = map.lines.back().from;
  line({kRoom + 64, 0}, {kRoom, 0}, 1);
  line({kRoom + 64, kRoom}, {2 * kRoom, kRoom}, 1);
  std::swap(map.lines[10].from, map.lines[10].to);
  map.sectors[2].ceiling = 0;
  map.sectors[2].tag = 8;
  map.lines[10].special = 0;
  setSpecial(10, 2, 8);
  const Level& level = load().level;
  EXPECT_EQ(level.sectors.size(), 4U);
  EXPECT_EQ(level.switches.size(), 2U);
  EXPECT_EQ(sectorNameOf(walkedEast(8)), "2");
}

TEST_F(ImportedMovers, areLiftsThatCarryThePlayerUp) {
  map.sectors[1].floor = 64;
  map.sectors[2].floor = 64;
  setSpecial(6, 62);
  load();
  EXPECT_EQ(sectorNameOf(walkedEast(0.9)), "0") << "it is too high to step on";
  const Walker walker = walkedEast(9);
  EXPECT_EQ(sectorNameOf(walker), "2");
  EXPECT_EQ(walker.feet.z, 2);
}

/// The loader wants textures of all steps that show at any end.
TEST_F(ImportedMovers, haveTexturesOfStepsThatShowAtAnyEnd) {
  map.sectors[1].floor = 64;
  for (Side& side : map.sides) side.upper = side.lower = "-";
  setSpecial(0, 60);
  setSpecial(1, 41);
  load();
  EXPECT_EQ(imported_.movers, 2U);
  EXPECT_TRUE(hasFinding(Part::Line, 6)) << "its steps show, without a texture";
  EXPECT_EQ(loaded_->level.movers.size(), 2U);
}

TEST_F(ImportedMovers, leaveLightsInTheAirAboveAFloorThatRises) {
  map.sectors[1].floorFlat = "LAMP";
  map.sectors[2].floor = 64;
  lights_.flats["LAMP"] = {};
  setSpecial(0, 18);
  const std::vector<LightSource>& lights = load().level.lights;
  ASSERT_FALSE(lights.empty());
  for (const LightSource& light : lights) EXPECT_EQ(light.position.z, 2.25);
}

TEST_F(ImportedMovers, leaveOutLightsWithoutAirAndLowerWhatHangs) {
  map.sectors[1].ceilingFlat = "LAMP";
  lights_.flats["LAMP"] = {};
  map.things.push_back({kRoom + 64, 64, 0, 59, 7});
  setSpecial(0, 42);
  const Level& level = load().level;
  EXPECT_TRUE(level.lights.empty());
  EXPECT_TRUE(hasFinding(Part::Sector, 1));
  ASSERT_EQ(level.sprites.size(), 1U);
  EXPECT_EQ(level.sprites[0].position.z, 0);
}

TEST_F(ImportedMovers, takeHangingTexturesAlong) {
  map.sectors[1].ceiling = 0;
  sideOf(map.lines[6]).middle = "GRATE";
  setSpecial(6, 1, 0);
  const Scene scene = load().scene();
  int count = 0;
  for (const Surface& surface : scene.level().surfaces)
    if (surface.kind == SurfaceKind::MaskedMiddle) ++count;
  EXPECT_EQ(count, 1);
}

TEST_F(ImportedMovers, areNoneInFrozenLevels) {
  map.sectors[1].ceiling = 0;
  setSpecial(6, 1, 0);
  for (const Doors doors : {Doors::Open, Doors::Closed}) {
    settings_.doors = doors;
    fs::remove_all(folder_);
    EXPECT_TRUE(load().level.movers.empty());
    EXPECT_TRUE(imported_.specials.empty());
  }
}

}  // namespace
}  // namespace hearth::doom
