#include "light/blended_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "level/mover.h"
#include "support/hall_and_cellar.h"

namespace hearth {
namespace {

constexpr double kTexel = 0.25;

/// The level and its light at some shares, and at rest on both sides of these.
class Moved {
 public:
  explicit Moved(std::vector<double> shares)
      : authored_(test::hallAndCellar()), shown_(loadedAt(shares)) {
    std::vector<LightAtRest> lights;
    const RestStates states(shares);
    for (std::size_t i = 0; i < states.count(); ++i) rests_.push_back(loadedAt(states.shares(i)));
    for (const LoadedLevel& rest : rests_) atRest_.push_back(bake(rest.scene(), settings(), 1));
    for (std::size_t i = 0; i < states.count(); ++i)
      lights.push_back({rests_[i].scene(), &atRest_[i]});
    light_ = blendedLight(shown_.scene(), lights, states.weights(), 2);
  }

  const BakedLight& light() const { return light_; }
  const BakedLight& atRest(std::size_t state) const { return atRest_[state]; }

  SurfaceId surface(SurfaceKind kind, std::string_view sector) const {
    for (const SurfaceId id : shown_.scene().shownSurfaces())
      if (shown_.level[id].kind == kind && shown_.level[shown_.level[id].sector].name == sector)
        return id;
    ADD_FAILURE() << sector << " has no such surface";
    return SurfaceId(0);
  }

 private:
  static BakeSettings settings() {
    BakeSettings settings;
    settings.texel = kTexel;
    return settings;
  }
  LoadedLevel loadedAt(std::span<const double> shares) const {
    return *levelAt(*authored_.result.loaded, authored_.source, shares).loaded;
  }

  SourcedResult authored_;
  LoadedLevel shown_;
  std::vector<LoadedLevel> rests_;
  std::vector<BakedLight> atRest_;
  BakedLight light_;
};

int levelAt(const BakedLight& light, SurfaceId id, int i, int j) {
  const auto& map = light.lightmaps[id.index()];
  return map ? map->at(i, j) : 0;
}

TEST(BlendedLight, isThatOfTheStateAtRest) {
  for (const double gate : {0.0, 1.0}) {
    const Moved moved({gate, 0});
    for (std::size_t i = 0; i < moved.light().lightmaps.size(); ++i) {
      const auto& map = moved.light().lightmaps[i];
      const auto& expected = moved.atRest(0).lightmaps[i];
      ASSERT_EQ(map.has_value(), expected.has_value()) << i;
      if (!map) continue;
      EXPECT_EQ(map->levels, expected->levels) << i;
    }
  }
}

TEST(BlendedLight, isTheWeightedSumWhereNothingMoves) {
  const Moved moved({0.25, 0});
  const SurfaceId floor = moved.surface(SurfaceKind::Floor, "cellar");
  int lit = 0;
  for (int i = 18; i < 36; ++i)
    for (int j = 0; j < 16; ++j) {
      const int open = levelAt(moved.atRest(1), floor, i, j);
      EXPECT_EQ(levelAt(moved.atRest(0), floor, i, j), 0) << "behind a closed door";
      EXPECT_EQ(levelAt(moved.light(), floor, i, j), std::floor(0.25 * open + 0.5));
      lit += open > 0 ? 1 : 0;
    }
  EXPECT_GT(lit, 50);
}

TEST(BlendedLight, movesWithTheEdgeOfAStep) {
  const Moved moved(
      {0.5, 0});  // the door's edge is at 1 m: four texels above that of the shut door
  const SurfaceId step = moved.surface(SurfaceKind::UpperStep, "hall");
  for (int i = 4; i < 12; ++i) {
    // At a quarter of a metre above the edge, of the shut, the half open and the open door.
    const int shut = levelAt(moved.atRest(0), step, i, 1);
    const int open = levelAt(moved.atRest(1), step, i, 9);
    EXPECT_EQ(levelAt(moved.light(), step, i, 5), std::floor(0.5 * (shut + open) + 0.5)) << i;
    EXPECT_NE(shut, open) << "else this tells nothing";
  }
}

TEST(BlendedLight, takesTheNearestLightOfASurfaceThatIsSmallerInAState) {
  const Moved moved({0.5, 0});
  const SurfaceId step = moved.surface(SurfaceKind::UpperStep, "hall");
  // 1.5 m above the edge there is no step when the door is open: it ends 1 m above its edge.
  const int shut = levelAt(moved.atRest(0), step, 8, 6);
  const int open = levelAt(moved.atRest(1), step, 8, 12);
  EXPECT_EQ(levelAt(moved.light(), step, 8, 10), std::floor(0.5 * (shut + open) + 0.5));
}

TEST(BlendedLight, takesTheLightOfASurfaceFromTheStatesThatShowIt) {
  const Moved moved({0, 0.5});
  const SurfaceId step = moved.surface(SurfaceKind::LowerStep, "hall");
  // The lift is up at 1 m in the second state, and flush with the hall in the first.
  for (int j = 0; j < 2; ++j) {
    const int up = levelAt(moved.atRest(1), step, -8, 2 + j);
    EXPECT_GT(up, 0);
    EXPECT_EQ(levelAt(moved.light(), step, -8, j), up) << j;
  }
}

}  // namespace
}  // namespace hearth
