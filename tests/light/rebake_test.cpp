#include "light/rebake.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "light/saved_bake.h"
#include "load/load.h"
#include "same_bakes.h"

namespace hearth {
namespace {

using test::expectSame;

constexpr int kThreads = 2;

class RebakeOfRooms : public testing::Test {
 protected:
  static Level rooms() {
    LoadResult result = loadLevel(HEARTH_SOURCE_DIR "/tests/levels/rooms.json");
    return std::move(result.loaded->level);
  }

  Level level_ = rooms();
  BakeSettings settings_ = level_.bake;
  LightMemory memory_;
};

TEST_F(RebakeOfRooms, AsksForNothingWhereNothingHasChanged) {
  const auto first = Rebake(memory_, level_, settings_, kThreads).finish();
  const Level again = rooms();
  Rebake rebake(memory_, again, settings_, kThreads);
  EXPECT_EQ(rebake.texelLightsLeft(), 0);
  expectSame(again, *rebake.finish(), *first);
}

TEST_F(RebakeOfRooms, AsksForOneLightWhereOneWasMoved) {
  Rebake first(memory_, level_, settings_, kThreads);
  const std::int64_t all = first.texelLightsLeft();
  ASSERT_TRUE(first.finish());
  ASSERT_GE(level_.lights.size(), 2U);
  level_.lights[0].position.z += 0.1;
  Rebake rebake(memory_, level_, settings_, kThreads);
  EXPECT_GT(rebake.texelLightsLeft(), 0);
  EXPECT_LT(rebake.texelLightsLeft(), all);
  expectSame(level_, *rebake.finish(), bake(level_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, AsksForAllWhereSettingsHaveChanged) {
  ASSERT_TRUE(Rebake(memory_, level_, settings_, kThreads).finish());
  settings_.samples = 4;
  Rebake rebake(memory_, level_, settings_, kThreads);
  EXPECT_GT(rebake.texelLightsLeft(), 0);
  expectSame(level_, *rebake.finish(), bake(level_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, TakesEachWayOfSampling) {
  for (const std::optional<int> samples : {std::optional(4), std::optional<int>()}) {
    settings_.samples = samples;
    ASSERT_TRUE(Rebake(memory_, level_, settings_, kThreads).finish());
    level_.lights[1].intensity += 10;
    expectSame(level_, *Rebake(memory_, level_, settings_, kThreads).finish(),
               bake(level_, settings_, kThreads));
  }
}

TEST_F(RebakeOfRooms, GivesTheSameLightWhereThereIsNoRoomToRemember) {
  LightMemory small(1000);
  Rebake first(small, level_, settings_, kThreads);
  const std::int64_t all = first.texelLightsLeft();
  ASSERT_TRUE(first.finish());
  EXPECT_LE(small.bytes(), 1000U);
  Rebake rebake(small, level_, settings_, kThreads);
  EXPECT_GT(rebake.texelLightsLeft(), all / 2);
  expectSame(level_, *rebake.finish(), bake(level_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, DoesNothingMoreOnceItIsStopped) {
  std::stop_source stop;
  stop.request_stop();
  Rebake rebake(memory_, level_, settings_, kThreads);
  EXPECT_FALSE(rebake.finish(nullptr, stop.get_token()));
  EXPECT_EQ(memory_.bytes(), 0U);
}

TEST_F(RebakeOfRooms, GoesOnFromWhereItWasStopped) {
  Rebake first(memory_, level_, settings_, 1);
  const std::int64_t all = first.texelLightsLeft();
  BakeProgress progress;
  std::stop_source stop;
  const std::jthread stopper([&] {
    while (2 * progress.texelsDone() <= progress.texels()) std::this_thread::yield();
    stop.request_stop();
  });
  const bool isWhole = first.finish(&progress, stop.get_token()).has_value();
  Rebake rebake(memory_, level_, settings_, kThreads);
  EXPECT_EQ(rebake.texelLightsLeft() == 0, isWhole);
  EXPECT_LT(rebake.texelLightsLeft(), all);
  expectSame(level_, *rebake.finish(), bake(level_, settings_, kThreads));
}

/// Mean difference of texels, in levels.
double meanDifference(const BakedLight& a, const BakedLight& b) {
  std::int64_t sum = 0;
  std::int64_t texels = 0;
  for (std::size_t i = 0; i < a.lightmaps.size(); ++i) {
    if (!a.lightmaps[i] && !b.lightmaps[i]) continue;
    const TexelRect rect = (a.lightmaps[i] ? a : b).lightmaps[i]->rect;
    texels += rect.count();
    for (int t = rect.j0; t < rect.j0 + rect.height; ++t)
      for (int s = rect.i0; s < rect.i0 + rect.width; ++s) {
        const int left = a.lightmaps[i] ? a.lightmaps[i]->at(s, t) : 0;
        const int right = b.lightmaps[i] ? b.lightmaps[i]->at(s, t) : 0;
        sum += std::abs(left - right);
      }
  }
  return static_cast<double>(sum) / static_cast<double>(texels);
}

TEST_F(RebakeOfRooms, DraftsWhatIsLeftRoughly) {
  const BakedLight full = bake(level_, settings_, kThreads);
  const BakedLight draft = Rebake(memory_, level_, settings_, kThreads).draft();
  EXPECT_GT(meanDifference(full, draft), 0);
  EXPECT_LT(meanDifference(full, draft), 6);
}

TEST_F(RebakeOfRooms, DraftsWhatIsKnownAsItIs) {
  const auto full = Rebake(memory_, level_, settings_, kThreads).finish();
  const BakedLight draft = Rebake(memory_, level_, settings_, kThreads).draft();
  EXPECT_EQ(encodeBake(level_, draft, settings_.texel, ""),
            encodeBake(level_, *full, settings_.texel, ""));
}

}  // namespace
}  // namespace hearth
