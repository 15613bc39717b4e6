#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "light/baking/baked_surface.h"
#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

TEST(SurfaceProgress, countsEveryTexelOnceInStepsOfAboutEqualSize) {
  BakeProgress bake;
  {
    SurfaceProgress seven(bake, 100, 7);
    for (int step = 1; step <= 7; ++step) {
      seven.step();
      EXPECT_EQ(bake.texelsDone(), 100 * step / 7);
    }
  }
  EXPECT_EQ(bake.texelsDone(), 100);
}

TEST(SurfaceProgress, countsTheRestWhenItEndsEarly) {
  BakeProgress bake;
  {
    SurfaceProgress early(bake, 100, 7);
    early.step();
  }
  EXPECT_EQ(bake.texelsDone(), 100);
}

/// Two rooms and three lights.
const std::string kRooms =
    "{'light': 0.1, 'sectors': {" +
    test::sectorText("a", "0,0, 6,0, 6,2, 6,3, 6,5, 0,5", 0, 3,
                     "[{'texture':'#808080'},{'texture':'#808080'},{'next':'b','texture':"
                     "'#808080'},{'texture':'#808080'},{'texture':'#808080'},{'texture':"
                     "'#808080'}]") +
    "," +
    test::sectorText("b", "6,2, 9,1, 9,4, 6,3", 0.3, 2.5,
                     "[{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'},"
                     "{'next':'a','texture':'#808080'}]") +
    "}}";

std::string lightsWith(std::string_view samples) {
  return fmt::format(
      "{{'lights':[{{'x':1,'y':1,'z':2.5,'falloff':0.4,'color':'#ffc080'}},"
      "{{'x':8,'y':2.2,'z':1,'falloff':0.7,'radius':0.2}},"
      "{{'x':3.3,'y':4.1,'z':0.4,'intensity':90}}],'bake':{{'samples':{}}}}}",
      samples);
}

TEST(Bake, givesTheSameBytesForAnyNumberOfThreads) {
  for (const std::string_view samples : {"1", "4", "'auto'"}) {
    const test::BakedRoom one(kRooms, lightsWith(samples), 1);
    for (const int threads : {2, 7, 64}) {
      const test::BakedRoom many(kRooms, lightsWith(samples), threads);
      for (std::size_t i = 0; i < one.light().lightmaps.size(); ++i) {
        ASSERT_EQ(one.light().lightmaps[i].has_value(), many.light().lightmaps[i].has_value());
        if (one.light().lightmaps[i]) {
          EXPECT_EQ(one.light().lightmaps[i]->levels, many.light().lightmaps[i]->levels)
              << samples << " samples, " << threads << " threads";
        }
      }
    }
  }
}

/// What another thread sees of a bake's progress.
struct Watched {
  BakedLight light;
  std::int64_t texels;
  std::vector<std::int64_t> done;  ///< each value once
};

Watched watchedBake(const Scene& scene, const BakeSettings& settings, int threads) {
  BakeProgress progress;
  std::vector<std::int64_t> seen = {0};
  std::atomic<bool> isWatching = false;
  std::jthread watcher([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (const std::int64_t done = progress.texelsDone(); done != seen.back())
        seen.push_back(done);
      isWatching = true;
    }
  });
  while (!isWatching) std::this_thread::yield();
  BakedLight light = bake(scene, settings, threads, &progress);
  watcher.request_stop();
  watcher.join();
  EXPECT_EQ(progress.texelsDone(), progress.texels());
  return {std::move(light), progress.texels(), std::move(seen)};
}

TEST(BakeProgress, growsToAllTexelsForAnyNumberOfThreads) {
  const LoadedLevel rooms = test::levelFrom(kRooms, lightsWith("1"));
  const BakedLight unwatched = bake(rooms.scene(), {}, 1);
  for (const int threads : {1, 2, 7}) {
    const Watched watched = watchedBake(rooms.scene(), {}, threads);
    EXPECT_EQ(watched.texels, watched.light.stats.texels);
    EXPECT_TRUE(std::ranges::is_sorted(watched.done));
    EXPECT_LE(watched.done.back(), watched.texels);
    for (std::size_t i = 0; i < unwatched.lightmaps.size(); ++i) {
      ASSERT_EQ(unwatched.lightmaps[i].has_value(), watched.light.lightmaps[i].has_value());
      if (unwatched.lightmaps[i]) {
        EXPECT_EQ(unwatched.lightmaps[i]->levels, watched.light.lightmaps[i]->levels);
      }
    }
  }
}

TEST(BakeProgress, countsEachTileOfASurfaceOnceItIsDone) {
  const LoadedLevel room = test::levelFrom(
      "{'light': 0.1, 'sectors': {" + test::sectorText("a", "0,0, 9,0, 9,9, 0,9", 0, 1) + "}}",
      "[{'x':1,'y':1,'z':0.5}]");
  const BakeSettings settings{.texel = 0.05};
  const LitSurfaces surfaces = makeLitSurfaces(room.scene(), settings.texel);
  const LightVisibilities visibilities(room.scene(), settings);
  SurfaceLight floor(room.scene(), surfaces, visibilities, settings.lambert,
                     room.level.sectors[0].floorSurface.value());
  const UsedTexels used(floor.surface(), floor.surface().texels);
  TexelSums sums(used.rect(), floor.channels());
  BakeProgress progress;
  // Sums are asked for before the lamp lights a tile.
  std::vector<std::int64_t> done;
  const auto sumsOf = [&](std::size_t) -> TexelSums& {
    done.push_back(progress.texelsDone());
    return sums;
  };
  addLights(floor, used, floor.facing(), settings, sumsOf, progress);
  const std::int64_t texels = used.rect().count();
  const std::int64_t tiles = std::ssize(tilesOf(used));
  std::vector<std::int64_t> expected;
  for (std::int64_t tile = 0; tile < tiles; ++tile) expected.push_back(texels * tile / tiles);
  EXPECT_GT(tiles, 4);
  EXPECT_EQ(done, expected);
  EXPECT_EQ(progress.texelsDone(), texels);
}

}  // namespace
}  // namespace hearth
