#include "level/plan_bounds.h"

#include <limits>

namespace hearth {

namespace {

/// Sectors more than this many times as long as the box of lights, shots and player, such as a lake
/// up to the horizon, do not enlarge the bounds.
constexpr double kMaxSizeRatio = 4;

/// Of the sectors with sides of at most `maxSide` metres.
Box boundsOfSectors(const Level& level, double maxSide) {
  Box bounds;
  for (const Sector& sector : level.sectors)
    if (sector.box.longerSide() <= maxSide) bounds = join(bounds, sector.box);
  return bounds;
}

}  // namespace

Box planBounds(const Level& level) {
  Box used;
  for (const LightSource& light : level.lights)
    if (light.hasPlace()) used.add(light.position.xy());
  for (const Shot& shot : level.shots) used.add(shot.eye.xy());
  if (level.player) used.add(level.player->eye.xy());
  const Box bounds = boundsOfSectors(level, kMaxSizeRatio * used.longerSide());
  if (touch(bounds, used)) return join(bounds, used);
  // Close together in a large hall, they say nothing about its size.
  return boundsOfSectors(level, std::numeric_limits<double>::infinity());
}

}  // namespace hearth
