#include "level/plan_bounds.h"

#include <limits>

namespace hearth {

namespace {

/// How many times as long as the box around lights, shots and player a sector may be to lie whole
/// within the bounds: a lake up to the horizon runs out of them.
constexpr double kMaxTimes = 4;

Box boundsUpTo(const Level& level, double most) {
  Box bounds;
  for (const Sector& sector : level.sectors)
    if (sector.box.longerSide() <= most) bounds = join(bounds, sector.box);
  return bounds;
}

}  // namespace

Box planBounds(const Level& level) {
  Box used;
  for (const LightSource& light : level.lights) used.add(light.position.xy());
  for (const Shot& shot : level.shots) used.add(shot.eye.xy());
  if (level.player) used.add(level.player->eye.xy());
  const Box near = boundsUpTo(level, kMaxTimes * used.longerSide());
  return near.longerSide() > 0 ? near : boundsUpTo(level, std::numeric_limits<double>::infinity());
}

}  // namespace hearth
