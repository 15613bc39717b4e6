// What levels/keep.json promises to show, measured in the level, its light and its shots. (Its
// pictures are held by `hearth check`: see tests/tools.)

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "light/bakery.h"
#include "load/load.h"
#include "load/source.h"
#include "support/in_tree.h"
#include "truth/truth_view.h"
#include "walkable.h"

namespace hearth {
namespace {

class Keep : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    SourcedResult sourced = loadLevelWithSource(test::inTree("levels/keep.json"));
    result_ = new LoadResult(std::move(sourced.result));
    source_ = new LevelSource(std::move(sourced.source));
  }
  static void TearDownTestSuite() {
    delete result_;
    delete source_;
  }
  void SetUp() override { ASSERT_TRUE(result_->loaded.has_value()); }

  static const Level& level() { return result_->loaded->level; }
  static Scene scene() { return result_->loaded->scene(); }
  static inline LoadResult* result_ = nullptr;
  static inline LevelSource* source_ = nullptr;
};

TEST_F(Keep, LoadsWithoutAWarning) {
  for (const Diagnostic& diagnostic : result_->diagnostics) ADD_FAILURE() << format(diagnostic);
}

TEST_F(Keep, HasEveryKindOfSurfaceButMiddlesAndStepsBetweenSkiesBelow) {
  std::set<SurfaceKind> kinds;
  for (const SurfaceId id : scene().shownSurfaces()) kinds.insert(level()[id].kind);
  for (std::size_t i = 0; i < kSurfaceKindCount; ++i) {
    const auto kind = static_cast<SurfaceKind>(i);
    const bool isElsewhere = kind == SurfaceKind::MaskedMiddle || kind == SurfaceKind::SkyLowerStep;
    EXPECT_NE(kinds.contains(kind), isElsewhere) << name(kind);
  }
}

/// What the shots show of the level: one ray for every square of 4 x 4 pixels.
struct Seen {
  double farthest = 0;  ///< metres from the eye
  double zLowest = std::numeric_limits<double>::infinity();
  double zHighest = -std::numeric_limits<double>::infinity();
  std::map<std::string, int> raysByTexture;
  int rays = 0;
};

Seen seenIn(const LoadedLevel& loaded) {
  constexpr int kPitch = 4;
  Seen seen;
  for (const Shot& shot : loaded.level.shots) {
    const TruthView view(loaded.level, loaded.textures, shot);
    for (int j = kPitch / 2; j < shot.height; j += kPitch)
      for (int i = kPitch / 2; i < shot.width; i += kPitch) {
        const TruthHit hit = view.hit(i + 0.5, j + 0.5);
        ++seen.rays;
        ++seen.raysByTexture[loaded.level.textures[hit.texture->texture.index()]];
        if (isSky(hit.kind)) continue;
        const Vec3 apart = hit.point - shot.eye;
        seen.farthest = std::max(seen.farthest, std::sqrt(dot(apart, apart)));
        seen.zLowest = std::min(seen.zLowest, hit.point.z);
        seen.zHighest = std::max(seen.zHighest, hit.point.z);
      }
  }
  return seen;
}

TEST_F(Keep, ItsShotsShowDistanceHeightAndTwelveTextures) {
  const Seen seen = seenIn(*result_->loaded);
  RecordProperty("farthest", std::to_string(seen.farthest) + " m");
  RecordProperty("heights", std::to_string(seen.zHighest - seen.zLowest) + " m");
  EXPECT_GE(seen.farthest, 40);
  EXPECT_GE(seen.zHighest - seen.zLowest, 15);
  int used = 0;
  for (const auto& [texture, rays] : seen.raysByTexture) {
    RecordProperty(texture, std::to_string(100.0 * rays / seen.rays) + " %");
    if (100 * rays >= seen.rays) ++used;
  }
  EXPECT_GE(used, 12);
}

TEST_F(Keep, IsNeitherDarkNorGlaring) {
  const BakedLight light = bake(scene(), level().bake, 2);
  std::int64_t texels = 0;
  std::int64_t lit = 0;
  std::int64_t full = 0;
  for (const auto& map : light.lightmaps) {
    if (!map) continue;
    for (int j = map->rect.j0; j < map->rect.j0 + map->rect.height; ++j)
      for (int i = map->rect.i0; i < map->rect.i0 + map->rect.width; ++i) {
        int brightest = 0;
        for (int channel = 0; channel < map->channels; ++channel)
          brightest = std::max<int>(brightest, map->at(i, j, channel));
        ++texels;
        lit += brightest > 0;
        full += brightest == 255;
      }
  }
  const auto percent = [texels](std::int64_t part) {
    return std::to_string(100.0 * static_cast<double>(part) / static_cast<double>(texels)) + " %";
  };
  RecordProperty("lit", percent(lit));
  RecordProperty("full", percent(full));
  EXPECT_GE(100 * lit, 40 * texels);
  EXPECT_LE(100 * lit, 95 * texels);
  EXPECT_LE(100 * full, texels);
}

/// What moves counts at both ends: the walker waits for it.
class KeepWalk : public Keep {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(Keep::SetUp());
    const std::vector<double> atTheirEnds(level().movers.size(), 1);
    moved_ = levelAt(*result_->loaded, *source_, atTheirEnds).loaded;
    ASSERT_TRUE(moved_.has_value());
  }

  test::Ways ways() const {
    test::Ways ways = test::waysOf(scene(), gait());
    const test::Ways others = test::waysOf(moved_->scene(), gait());
    for (std::size_t i = 0; i < ways.size(); ++i)
      ways[i].insert(others[i].begin(), others[i].end());
    return ways;
  }
  bool hasRoom(std::size_t i) const {
    return test::hasRoom(scene(), level().sectors[i], gait()) ||
           test::hasRoom(moved_->scene(), moved_->level.sectors[i], gait());
  }

 private:
  test::Gait gait() const { return {level().player->stepHeight, level().player->radius}; }

  std::optional<LoadedLevel> moved_;
};

TEST_F(KeepWalk, LeadsFromTheRoadToWhereverABodyHasRoom) {
  const std::set<std::size_t> reached = test::reachableFrom(ways(), level().player->sector.index());
  for (std::size_t i = 0; i < level().sectors.size(); ++i)
    if (hasRoom(i)) {
      EXPECT_TRUE(reached.contains(i)) << level().sectors[i].name;
    }
}

TEST_F(KeepWalk, LeadsBackToTheRoadFromEverywhere) {
  const std::set<std::size_t> homing =
      test::reachableFrom(test::reversed(ways()), level().player->sector.index());
  for (std::size_t i = 0; i < level().sectors.size(); ++i)
    if (hasRoom(i)) {
      EXPECT_TRUE(homing.contains(i)) << level().sectors[i].name;
    }
}

TEST_F(KeepWalk, KnowsRoomsFromParapets) {
  int rooms = 0;
  for (std::size_t i = 0; i < level().sectors.size(); ++i) {
    const std::string& name = level().sectors[i].name;
    rooms += hasRoom(i);
    if (name.starts_with("parapet") || name.starts_with("rampart")) {
      EXPECT_EQ(hasRoom(i), name.starts_with("rampart")) << name;
    }
  }
  EXPECT_GE(rooms, 60);
}

}  // namespace
}  // namespace hearth
