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
inline Walker standing(const Scene& scene, const std::string& sector, Vec3 feet, double angle = 0) {
  const double eyeHeight = scene.level().player.value_or(Player{}).eyeHeight;
  Walker walker = walkerAt(scene, sectorNamed(scene.level(), sector),
                           {feet.x, feet.y, feet.z + eyeHeight}, angle, 0);
  walker = walked(scene, walker, {});
  EXPECT_TRUE(walker.isOnGround) << walker.feet.z;
  return walker;
}

/// After so many ticks of one input, every one of which must leave the walker in its sector.
inline Walker after(const Scene& scene, Walker walker, const WalkInput& input, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    walker = walked(scene, walker, input);
    EXPECT_TRUE(contains(scene, scene[walker.sector], walker.feet, kPositionSlack));
    const Eye eye = eyeOf(scene, walker);
    EXPECT_TRUE(contains(scene, scene[eye.sector], eye.point, kPositionSlack));
  }
  return walker;
}

/// A wall that nothing passes.
inline const std::string kSolid = "{'texture':'#808080'}";

inline constexpr WalkInput kForward{.forward = 127};
inline constexpr WalkInput kRun{.forward = 127, .run = true};

}  // namespace hearth::test
