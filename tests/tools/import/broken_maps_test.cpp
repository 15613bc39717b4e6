// Maps that are broken in every way that maps are: whatever an import makes of one is a level that
// loads, or is refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "import/doom/ground_plan.h"
#include "import/doom/import_map.h"
#include "import/doom/materials.h"
#include "load/load.h"
#include "map_builder.h"
#include "map_lumps.h"
#include "pictures_builder.h"
#include "random_levels/random.h"

namespace hearth::doom {

namespace {

namespace fs = std::filesystem;

constexpr int kUnits = 64;   // of a cell
constexpr int kCells = 4;    // of a row and of a column
constexpr int kFar = 32767;  // map units
constexpr int kMaps = 1000;
constexpr std::uint16_t kLamp = 2028;   // type of a thing that stands
constexpr std::uint16_t kHanging = 50;  // and of one that hangs from the ceiling

/// Small maps: a grid of rooms, then broken at random.
class BrokenMaps : public testing::Test, protected MapBuilder {
 protected:
  BrokenMaps() {
    fs::remove_all(folder_);
    game_.add("PLAYPAL", palette()).add("PNAMES", patchNames({"PATCH"}));
    std::vector<std::string> textures;
    for (const char* name : {"UPPER", "LOWER", "WALL", "SKY1"})
      textures.push_back(definition(name, 8, 8, {{0, 0, 0}}));
    textures.push_back(definition("GRATE", 16, 8, {{0, 0, 0}}));
    game_.add("TEXTURE1", texturesOf(textures)).add("PATCH", plainPatch(8, 8, 9));
    game_.add("F_START").add("FLOOR", flatOf(1)).add("CEIL", flatOf(2)).add("F_END");
    game_.add("S_START").add("COLUA0", plainPatch(4, 8, 3)).add("GOR2A0", plainPatch(4, 8, 4));
    game_.add("S_END");
    writeTextures();
  }
  ~BrokenMaps() override { fs::remove_all(folder_); }

  /// All that any of the maps wears, once: that takes longer than the rest.
  void writeTextures() {
    const Wad wad = opened(game_);
    const Pictures pictures = *Pictures::read(wad);
    Findings findings;
    Materials materials(pictures, "MAP01", findings);
    for (const char* name : {"UPPER", "LOWER", "WALL", "GRATE"}) materials.wall(name, {});
    for (const char* name : {"FLOOR", "CEIL"}) materials.flat(name);
    materials.sky();
    for (const std::uint16_t type : {kLamp, kHanging})
      ASSERT_TRUE(Sprites(pictures, materials, findings).lookOf(*findThingType(type)));
    ASSERT_TRUE(materials.write(folder_ / "textures"));
    EXPECT_TRUE(findings.empty());
  }

  int whole(int least, int most) { return static_cast<int>(random_.between(least, most)); }
  template <typename Container>
  auto& any(Container& of) {
    return of[random_.below(of.size())];
  }

  /// Rooms in a grid, some of which are one, and a player in the first.
  void makeRooms() {
    map = Map{};
    map.name = "MAP01";
    std::array<std::uint32_t, kCells * kCells> sectors{};
    for (std::size_t i = 0; i < sectors.size(); ++i)
      sectors[i] = i == 0 || whole(0, 2) > 0 ? sector(8 * whole(0, 4), 8 * whole(10, 20))
                                             : sectors[random_.below(i)];
    const auto at = [&](int column, int row) -> std::optional<std::uint32_t> {
      if (column < 0 || row < 0 || column == kCells || row == kCells) return std::nullopt;
      return sectors[static_cast<std::size_t>(row * kCells + column)];
    };
    for (int i = 0; i < kCells; ++i)
      for (int k = 0; k <= kCells; ++k) {
        wall({kUnits * k, kUnits * i}, {kUnits * k, kUnits * (i + 1)}, at(k, i), at(k - 1, i));
        wall({kUnits * (i + 1), kUnits * k}, {kUnits * i, kUnits * k}, at(i, k), at(i, k - 1));
      }
    map.things.push_back({kUnits / 2, kUnits / 2, 90, 1, 7});
    map.things.push_back({3 * kUnits / 2, kUnits / 2, 90, kLamp, 7});
  }

  void wall(Vertex from, Vertex to, std::optional<std::uint32_t> right,
            std::optional<std::uint32_t> left) {
    if (right)
      line(from, to, right, left);
    else
      line(to, from, left, right);
  }

  /// All rooms have one of three tags, and half of the lines start something.
  void makeMovers() {
    for (Sector& sector : map.sectors) {
      sector.tag = static_cast<std::uint16_t>(whole(1, 3));
      if (whole(0, 3) == 0) sector.ceiling = sector.floor;
    }
    for (Line& line : map.lines) {
      if (whole(0, 1) == 0) continue;
      line.special = lineTypes()[random_.below(lineTypes().size())].number;
      line.tag = static_cast<std::uint16_t>(whole(1, 3));
    }
  }

  /// Lines between random places: they cross, overlap, and miss each other by hardly anything.
  void makeTangle() {
    map = Map{};
    map.name = "MAP01";
    const int size = random_.pick({8, 40, 300, 4000, kFar - 3});
    for (int i = 0; i < 4; ++i) sector(0, 64 + i);
    for (int i = whole(6, 30); i > 0; --i) {
      const Vertex from{whole(-size, size), whole(-size, size)};
      Vertex to{whole(-size, size), whole(-size, size)};
      switch (whole(0, 3)) {
        case 0:  // short
          to = {from.x + whole(-3, 3), from.y + whole(-3, 3)};
          break;
        case 1:  // nearly through the middle
          to = {whole(-2, 2) - from.x, whole(-2, 2) - from.y};
          break;
        default:
          break;
      }
      line(from, to, static_cast<std::uint32_t>(whole(0, 3)),
           static_cast<std::uint32_t>(whole(0, 3)));
    }
    for (int i = 0; i < 4; ++i)
      map.things.push_back({whole(-size, size), whole(-size, size), 0, 1, 7});
  }

  void breakSomething() {
    const std::vector<std::function<void()>> ways = {
        // Things
        [&] { any(map.things).x = whole(-kFar, kFar); },
        [&] {
          any(map.things) = {whole(-99, 399), whole(-99, 399), whole(-999, 999), 1, 7};
        },
        [&] {
          any(map.things) = {32 * whole(0, 8), 32 * whole(0, 8), 0, 1, 7};
        },
        [&] {
          map.things.push_back({32 * whole(0, 8), 32 * whole(0, 8), 0, kHanging, 7});
        },
        [&] {
          map.things.clear(), map.things.push_back({9, 9, 0, 3004, 7});
        },
        // Heights
        [&] { any(map.sectors).ceiling = any(map.sectors).floor; },
        [&] { any(map.sectors).ceiling = any(map.sectors).floor + whole(-4, 60); },
        [&] { any(map.sectors).floor = whole(-kFar, kFar); },
        [&] { any(map.sectors).ceiling = whole(0, 1) == 0 ? kFar : -kFar; },
        [&] { any(map.sectors).ceilingFlat = kSkyFlat; },
        [&] { any(map.sectors).floorFlat = kSkyFlat; },
        [&] { any(map.sectors).tag = any(map.lines).tag = 1; },
        [&] { any(map.lines).special = static_cast<std::uint16_t>(whole(0, 137)); },
        // Lines
        [&] { map.lines.erase(map.lines.begin() + whole(0, lastLine())); },
        [&] { map.lines.push_back(any(map.lines)); },
        [&] { any(map.lines).to = any(map.lines).from; },
        [&] { any(map.lines).from = any(map.lines).from; },
        [&] { std::swap(any(map.lines).from, any(map.lines).to); },
        [&] { any(map.lines).sides[1] = any(map.lines).sides[0]; },
        [&] { any(map.lines).sides[0].reset(); },
        [&] { std::swap(any(map.lines).sides[0], any(map.lines).sides[1]); },
        // Vertices
        [&] {
          any(map.vertices) = {whole(-1, 1), whole(-1, 1)};
        },
        [&] { any(map.vertices).x += whole(-2, 2); },
        [&] { any(map.vertices).y += whole(-70, 70); },
        [&] {
          any(map.vertices) = {whole(-kFar, kFar), whole(-kFar, kFar)};
        },
        [&] { any(map.vertices) = any(map.vertices); },
        // Sides
        [&] { any(map.sides).sector = any(map.sides).sector; },
        [&] { any(map.sides).middle = whole(0, 1) == 0 ? "GRATE" : "GONE"; },
        [&] { any(map.sides).upper = any(map.sides).lower = "-"; },
        [&] { any(map.sides).yOffset = whole(-kFar, kFar); },
    };
    random_.pickFrom(ways)();
  }

  int lastLine() const { return static_cast<int>(map.lines.size()) - 1; }

  /// What the loader says of the level that a map becomes; nothing of a map that is refused.
  std::string mistakesOfImport(Doors doors) {
    WadBuilder builder = game_;
    addMap(builder, map);
    const Wad wad = opened(builder);
    Imported imported;
    const auto converted =
        convertMap({wad, *Pictures::read(wad), *parseLightTable(ownLightTable())}, map.name,
                   {.folder = folder_, .doors = doors}, imported);
    if (!converted) return "";
    movers_ += imported.movers;
    std::ofstream(folder_ / "map01.lights.json") << converted->lights;
    std::ofstream(folder_ / "map01.json") << converted->level;
    std::string mistakes;
    for (const Diagnostic& diagnostic : loadLevel(imported.level).diagnostics)
      if (diagnostic.isError) mistakes += format(diagnostic) + "\n";
    return mistakes;
  }

  std::size_t movers_ = 0;  ///< of all levels
  random_levels::Random random_{1};
  WadBuilder game_;
  fs::path folder_ = fs::path(testing::TempDir()) / fmt::format("hearth-maps-{}", ::getpid());
};

TEST_F(BrokenMaps, becomeLevelsThatLoadOrAreRefused) {
  for (int i = 0; i < kMaps; ++i) {
    makeRooms();
    for (int k = whole(0, 6); k > 0; --k) breakSomething();
    EXPECT_EQ(mistakesOfImport(i % 2 == 0 ? Doors::Open : Doors::Closed), "") << "map " << i;
  }
}

TEST_F(BrokenMaps, areLevelsWhoseMoversAreSoundInAllTheirEnds) {
  for (int i = 0; i < kMaps; ++i) {
    makeRooms();
    makeMovers();
    for (int k = whole(0, 6); k > 0; --k) breakSomething();
    EXPECT_EQ(mistakesOfImport(Doors::Moving), "") << "map " << i;
  }
  EXPECT_GT(movers_, 2U * kMaps);
}

TEST_F(BrokenMaps, areLevelsThatLoadHoweverTheirLinesAreTangled) {
  for (int i = 0; i < kMaps; ++i) {
    makeTangle();
    EXPECT_EQ(mistakesOfImport(Doors::Closed), "") << "map " << i;
  }
}

}  // namespace

}  // namespace hearth::doom
