#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "level/locate.h"
#include "load/load.h"
#include "math/tolerance.h"
#include "support/level_text.h"
#include "walk/walker.h"

namespace hearth::test {

inline SectorId sectorNamed(const Level& level, const std::string& name) {
  for (std::size_t i = 0; i < level.sectors.size(); ++i)
    if (level.sectors[i].name == name) return SectorId(i);
  ADD_FAILURE() << "no sector " << name;
  return {};
}

/// Stands on `feet` with the angle given.
inline Walker standing(const Level& level, const std::string& sector, Vec3 feet, double angle = 0) {
  const double eyeHeight = level.player.value_or(Player{}).eyeHeight;
  Walker walker =
      walkerAt(level, sectorNamed(level, sector), {feet.x, feet.y, feet.z + eyeHeight}, angle, 0);
  walker = walked(level, walker, {});
  EXPECT_TRUE(walker.isOnGround) << walker.feet.z;
  return walker;
}

/// After so many ticks of one input, every one of which must leave the walker in its sector.
inline Walker after(const Level& level, Walker walker, const WalkInput& input, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    walker = walked(level, walker, input);
    EXPECT_TRUE(contains(level, level[walker.sector], walker.feet, kPositionSlack));
    const Eye eye = eyeOf(level, walker);
    EXPECT_TRUE(contains(level, level[eye.sector], eye.point, kPositionSlack));
  }
  return walker;
}

inline constexpr WalkInput kForward{.forward = 127};
inline constexpr WalkInput kRun{.forward = 127, .run = true};

}  // namespace hearth::test
