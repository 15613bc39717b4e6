#include "light/rebake.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "light/saved_bake.h"
#include "load/load.h"
#include "same_bakes.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::expectSame;

constexpr int kThreads = 2;

class RebakeOfRooms : public testing::Test {
 protected:
  static LoadedLevel rooms() {
    return loadLevel(test::inTree("tests/levels/rooms.json")).loaded.value();
  }

  LoadedLevel loaded_ = rooms();
  Level& level_ = loaded_.level;
  const Scene scene_ = loaded_.scene();
  BakeSettings settings_ = level_.bake;
  LightMemory memory_;
};

TEST_F(RebakeOfRooms, AsksForNothingWhereNothingHasChanged) {
  const auto first = Rebake(memory_, scene_, settings_, kThreads).finish();
  const LoadedLevel again = rooms();
  Rebake rebake(memory_, again.scene(), settings_, kThreads);
  EXPECT_EQ(rebake.texelLightsLeft(), 0);
  expectSame(again.scene(), *rebake.finish(), *first);
}

TEST_F(RebakeOfRooms, AsksForOneLightWhereOneWasMoved) {
  Rebake first(memory_, scene_, settings_, kThreads);
  const std::int64_t all = first.texelLightsLeft();
  ASSERT_TRUE(first.finish());
  ASSERT_GE(level_.lights.size(), 2U);
  level_.lights[0].position.z += 0.1;
  Rebake rebake(memory_, scene_, settings_, kThreads);
  EXPECT_GT(rebake.texelLightsLeft(), 0);
  EXPECT_LT(rebake.texelLightsLeft(), all);
  expectSame(scene_, *rebake.finish(), bake(scene_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, AsksForAllWhereSettingsHaveChanged) {
  ASSERT_TRUE(Rebake(memory_, scene_, settings_, kThreads).finish());
  settings_.samples = 4;
  Rebake rebake(memory_, scene_, settings_, kThreads);
  EXPECT_GT(rebake.texelLightsLeft(), 0);
  expectSame(scene_, *rebake.finish(), bake(scene_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, TakesEachWayOfSampling) {
  for (const std::optional<int> samples : {std::optional(4), std::optional<int>()}) {
    settings_.samples = samples;
    ASSERT_TRUE(Rebake(memory_, scene_, settings_, kThreads).finish());
    level_.lights[1].intensity += 10;
    expectSame(scene_, *Rebake(memory_, scene_, settings_, kThreads).finish(),
               bake(scene_, settings_, kThreads));
  }
}

TEST_F(RebakeOfRooms, GivesTheSameLightWhereThereIsNoRoomToRemember) {
  LightMemory small(1000);
  Rebake first(small, scene_, settings_, kThreads);
  const std::int64_t all = first.texelLightsLeft();
  ASSERT_TRUE(first.finish());
  EXPECT_LE(small.bytes(), 1000U);
  Rebake rebake(small, scene_, settings_, kThreads);
  EXPECT_GT(rebake.texelLightsLeft(), all / 2);
  expectSame(scene_, *rebake.finish(), bake(scene_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, DoesNothingMoreOnceItIsStopped) {
  std::stop_source stop;
  stop.request_stop();
  Rebake rebake(memory_, scene_, settings_, kThreads);
  EXPECT_FALSE(rebake.finish(nullptr, stop.get_token()));
  EXPECT_EQ(memory_.bytes(), 0U);
}

TEST_F(RebakeOfRooms, GoesOnFromWhereItWasStopped) {
  Rebake first(memory_, scene_, settings_, 1);
  const std::int64_t all = first.texelLightsLeft();
  BakeProgress progress;
  std::stop_source stop;
  const std::jthread stopper([&] {
    while (2 * progress.texelsDone() <= progress.texels()) std::this_thread::yield();
    stop.request_stop();
  });
  const bool isWhole = first.finish(&progress, stop.get_token()).has_value();
  Rebake rebake(memory_, scene_, settings_, kThreads);
  EXPECT_EQ(rebake.texelLightsLeft() == 0, isWhole);
  EXPECT_LT(rebake.texelLightsLeft(), all);
  expectSame(scene_, *rebake.finish(), bake(scene_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, TakesWhatAnyOfTheBakesFoundThatAreKept) {
  for (const std::size_t bakes : {1U, 2U, 3U}) {
    LightMemory memory;
    memory.keepBakes(bakes);
    std::vector<std::int64_t> left;
    for (const double rise : {0.0, 0.1, 0.2, 0.0}) {
      LoadedLevel other = rooms();
      other.level.lights[0].position.z += rise;
      Rebake rebake(memory, other.scene(), settings_, kThreads);
      left.push_back(rebake.texelLightsLeft());
      expectSame(other.scene(), *rebake.finish(), bake(other.scene(), settings_, kThreads));
    }
    EXPECT_GT(left[2], 0);
    EXPECT_EQ(left[3] == 0, bakes == 3) << bakes;
  }
}

TEST_F(RebakeOfRooms, TakesPartsFromSeveralBakes) {
  memory_.keepBakes(3);
  for (const auto& [first, second] : {std::pair(0.1, 0.0), {0.0, 0.1}}) {
    LoadedLevel other = rooms();
    other.level.lights[0].position.z += first;
    other.level.lights[1].position.z += second;
    ASSERT_TRUE(Rebake(memory_, other.scene(), settings_, kThreads).finish());
  }
  level_.lights[0].position.z += 0.1;
  level_.lights[1].position.z += 0.1;
  Rebake rebake(memory_, scene_, settings_, kThreads);
  EXPECT_EQ(rebake.texelLightsLeft(), 0);
  expectSame(scene_, *rebake.finish(), bake(scene_, settings_, kThreads));
}

TEST_F(RebakeOfRooms, LetsGoOfTheOldestBakeFirstWhereThereIsNoRoom) {
  ASSERT_TRUE(Rebake(memory_, scene_, settings_, kThreads).finish());
  LightMemory small(memory_.bytes());
  small.keepBakes(2);
  ASSERT_TRUE(Rebake(small, scene_, settings_, kThreads).finish());
  level_.lights[0].intensity += 1;
  ASSERT_TRUE(Rebake(small, scene_, settings_, kThreads).finish());
  EXPECT_LE(small.bytes(), memory_.bytes());
  EXPECT_EQ(Rebake(small, scene_, settings_, kThreads).texelLightsLeft(), 0);
  level_.lights[0].intensity -= 1;
  EXPECT_GT(Rebake(small, scene_, settings_, kThreads).texelLightsLeft(), 0);
}

TEST_F(RebakeOfRooms, KeepsOnceWhatBakesHaveInCommon) {
  memory_.keepBakes(4);
  ASSERT_TRUE(Rebake(memory_, scene_, settings_, kThreads).finish());
  const std::size_t one = memory_.bytes();
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(Rebake(memory_, scene_, settings_, kThreads).finish());
  EXPECT_GT(memory_.bytes(), one);
  EXPECT_LT(memory_.bytes(), 1.1 * static_cast<double>(one)) << "but for the lists of surfaces";
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
  const BakedLight full = bake(scene_, settings_, kThreads);
  const BakedLight draft = Rebake(memory_, scene_, settings_, kThreads).draft();
  EXPECT_GT(meanDifference(full, draft), 0);
  EXPECT_LT(meanDifference(full, draft), 6);
}

TEST_F(RebakeOfRooms, DraftsWhatIsKnownAsItIs) {
  const auto full = Rebake(memory_, scene_, settings_, kThreads).finish();
  const BakedLight draft = Rebake(memory_, scene_, settings_, kThreads).draft();
  EXPECT_EQ(encodeBake(scene_, draft, settings_.texel, ""),
            encodeBake(scene_, *full, settings_.texel, ""));
}

/// Two rooms whose floors are level: no step shows between them.
LoadedLevel roomsWith(std::string_view portal) {
  constexpr std::string_view kSolid = "{'texture':'#808080'}";
  return test::levelFrom(
      fmt::format("{{'sectors':{{{},{}}}}}",
                  test::sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3,
                                   fmt::format("[{0},{1},{0},{0}]", kSolid, portal)),
                  test::sectorText("east", "4,0, 8,0, 8,4, 4,4", 0, 3,
                                   fmt::format("[{0},{0},{0},{{'next':'west'}}]", kSolid))),
      "[{'x':2,'y':2,'z':1.5,'intensity':200}]");
}

TEST(Rebake, givesTheLightOfTheLevelWhereAStepThatDoesNotShowGetsATexture) {
  LightMemory memory;
  const LoadedLevel before = roomsWith("{'next':'east'}");
  const LoadedLevel after = roomsWith("{'next':'east','lower':'#808080'}");
  ASSERT_LT(before.level.surfaces.size(), after.level.surfaces.size());
  ASSERT_TRUE(Rebake(memory, before.scene(), before.level.bake, kThreads).finish());
  Rebake rebake(memory, after.scene(), after.level.bake, kThreads);
  EXPECT_EQ(rebake.texelLightsLeft(), 0);
  expectSame(after.scene(), *rebake.finish(), bake(after.scene(), after.level.bake, kThreads));
}

}  // namespace
}  // namespace hearth
