// Levels with a grid over the walls of every sector against the same without any: the same light,
// pictures and walks, to the byte.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "level/link_surfaces.h"
#include "level/locate.h"
#include "light/saved_bake.h"
#include "load/load.h"
#include "random_levels/random.h"
#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "support/in_tree.h"
#include "support/temporary_folder.h"
#include "walk/walker.h"

namespace hearth {
namespace {

using random_levels::Random;

constexpr std::size_t kAll = 1;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

LoadedLevel loadedWith(const std::filesystem::path& file, std::size_t fewestWalls) {
  LoadResult result = loadLevel(file);
  if (!result.loaded)
    throw std::runtime_error(format(result.diagnostics.front()));  // a failure of the test
  addWallGrids(result.loaded->level, fewestWalls);
  return *std::move(result.loaded);
}

void expectSamePlaces(const LoadedLevel& with, const LoadedLevel& without, Random& random) {
  for (std::size_t i = 0; i < with.level.sectors.size(); ++i) {
    const Sector& sector = with.level.sectors[i];
    const Sector& plain = without.level.sectors[i];
    const auto expectSame = [&](Vec2 p) {
      EXPECT_EQ(contains(with.level, sector, p), contains(without.level, plain, p)) << p.x << p.y;
      const Vec3 at{p.x, p.y, with.scene().zFloor(sector)};
      EXPECT_EQ(contains(with.scene(), sector, at, 1e-3),
                contains(without.scene(), plain, at, 1e-3));
      EXPECT_EQ(nudgedInside(with.scene(), sector, at), nudgedInside(without.scene(), plain, at));
    };
    for (int k = 0; k < 8; ++k)
      expectSame({random.real(sector.box.min.x - 1, sector.box.max.x + 1),
                  random.real(sector.box.min.y - 1, sector.box.max.y + 1)});
    for (const Segment& wall : with.level.segmentsOf(sector)) {
      expectSame(wall.p0);
      expectSame(lerp(wall.p0, wall.p1, 0.5));
      expectSame({wall.p0.x, random.real(sector.box.min.y, sector.box.max.y)});
      expectSame({random.real(sector.box.min.x, sector.box.max.x), wall.p0.y});
    }
  }
}

void expectSameLightAndPictures(const LoadedLevel& with, const LoadedLevel& without,
                                const BakeSettings& settings) {
  const BakedLight light = bake(with.scene(), settings, 1);
  const BakedLight plainLight = bake(without.scene(), settings, 1);
  EXPECT_EQ(encodeBake(with.scene(), light, settings.texel, ""),
            encodeBake(without.scene(), plainLight, settings.texel, ""));
  const Renderer renderer(with.scene(), with.textures, light, {});
  const Renderer plain(without.scene(), without.textures, plainLight, {});
  for (const Shot& shot : with.level.shots)
    EXPECT_EQ(renderer.draw(cameraOf(shot), LightMode::Both).pixels(),
              plain.draw(cameraOf(shot), LightMode::Both).pixels())
        << shot.name;
}

void expectSameWalk(const LoadedLevel& with, const LoadedLevel& without, const Shot& shot,
                    Random& random) {
  Walker walker = walkerAt(with.scene(), shot.sector, shot.eye, shot.angle, shot.pitch);
  Walker plain = walkerAt(without.scene(), shot.sector, shot.eye, shot.angle, shot.pitch);
  ASSERT_EQ(walker, plain);
  const auto part = [&](int most) { return static_cast<int>(random.between(-most, most)); };
  WalkInput input;
  for (int tick = 0; tick < 200; ++tick) {
    if (tick % 20 == 0)
      input = {.forward = part(127),
               .right = part(127),
               .up = part(127),
               .turn = part(3000),
               .run = random.chance(0.5),
               .jump = random.chance(0.3),
               .crouch = random.chance(0.2),
               .toggleFlight = random.chance(0.1)};
    walker = walked(with.scene(), walker, input);
    plain = walked(without.scene(), plain, input);
    ASSERT_EQ(walker, plain) << "tick " << tick;
    ASSERT_EQ(eyeOf(with.scene(), walker), eyeOf(without.scene(), plain)) << "tick " << tick;
    input.toggleFlight = false;
  }
}

void expectSame(const std::filesystem::path& file, std::uint64_t seed) {
  const LoadedLevel with = loadedWith(file, kAll);
  const LoadedLevel without = loadedWith(file, kNone);
  ASSERT_EQ(with.level.wallGrids.size(), with.level.sectors.size());
  ASSERT_TRUE(without.level.wallGrids.empty());
  Random random(seed);
  expectSamePlaces(with, without, random);
  BakeSettings settings = with.level.bake;
  settings.texel = 0.5;
  expectSameLightAndPictures(with, without, settings);
  for (const Shot& shot : with.level.shots)
    ASSERT_NO_FATAL_FAILURE(expectSameWalk(with, without, shot, random)) << shot.name;
}

TEST(WallGrids, changeNothingInRandomLevels) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRandomLevelTextures(folder.path() / "textures"));
  for (std::uint64_t seed = 0; seed < HEARTH_RANDOM_LEVELS && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const RandomLevel level = makeRandomLevel(seed);
    ASSERT_TRUE(writeRandomLevel(folder.path(), level));
    expectSame(folder.path() / (level.name + ".json"), seed);
  }
}

/// A hall of so many pillars each way, in one sector, with a lamp of some breadth.
std::string hallOf(int pillars) {
  std::string rows;
  const int cells = 2 * pillars + 3;
  for (int y = 0; y < cells; ++y) {
    rows += y == 0 ? "\"" : ", \"";
    for (int x = 0; x < cells; ++x) {
      const bool isAround = std::min(x, y) == 0 || std::max(x, y) == cells - 1;
      rows += isAround || (x % 2 == 0 && y % 2 == 0) ? '#' : '.';
    }
    rows += '"';
  }
  return R"({"light": 0, "player": {"x": 1.5, "y": 1.5, "z": 1.6},
    "shots": [{"name": "along", "camera": [1.5, 1.5, 1.6, 40, 0]},
              {"name": "across", "camera": [7.5, 5.5, 0.4, 200, 20]}],
    "grid": {"legend": {"#": {"wall": "#a08060"},
                        ".": {"floor": {"texture": "#606060"},
                              "ceiling": {"z": 3, "texture": "#a0a0a0"}}},
             "rows": [)" +
         rows + "]}}";
}

constexpr const char* kLampsInHall = R"({"lights": [
  {"x": 5.5, "y": 5.2, "z": 2.5, "intensity": 250, "falloff": 0.5, "radius": 0.2},
  {"x": 9.5, "y": 13.4, "z": 1, "intensity": 250, "falloff": 0.5}]})";

TEST(WallGrids, changeNothingInAHallOfManyPillars) {
  const test::TemporaryFolder folder;
  folder.write("hall.lights.json", kLampsInHall);
  expectSame(folder.write("hall.json", hallOf(12)), 1);
}

TEST(WallGrids, areOnlyInSectorsWithManyWalls) {
  const test::TemporaryFolder folder;
  const auto gridsIn = [&](int pillars) {
    return loadLevel(folder.write("hall.json", hallOf(pillars))).loaded->level.wallGrids.size();
  };
  EXPECT_EQ(gridsIn(11), 0U) << "of 488 walls";
  EXPECT_EQ(gridsIn(12), 1U) << "of 580 walls";
}

TEST(WallGrids, changeNothingInTheLevelsThatAreShown) {
  for (const char* const name : {"tutorial", "gaol", "maze"}) {
    SCOPED_TRACE(name);
    expectSame(test::inTree("levels") / (std::string(name) + ".json"), 1);
  }
}

}  // namespace
}  // namespace hearth
