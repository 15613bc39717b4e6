#include "level/plan_frame.h"

namespace hearth {

namespace {

/// How much larger than where lights, shots and player are a sector can be and still be in the
/// frame as a whole: a lake up to the horizon runs out of it.
constexpr double kMostTimes = 4;

PlanBox frameWithin(const Level& level, double most) {
  PlanBox frame;
  for (const Sector& sector : level.sectors) {
    if (PlanBox{sector.boxMin, sector.boxMax}.longerSide() > most) continue;
    frame.add(sector.boxMin);
    frame.add(sector.boxMax);
  }
  return frame;
}

}  // namespace

PlanBox planFrame(const Level& level) {
  PlanBox used;
  for (const LightSource& light : level.lights) used.add(light.position.xy());
  for (const Shot& shot : level.shots) used.add(shot.eye.xy());
  if (level.player) used.add(level.player->eye.xy());
  const PlanBox near = frameWithin(level, kMostTimes * used.longerSide());
  return near.longerSide() > 0 ? near : frameWithin(level, std::numeric_limits<double>::infinity());
}

}  // namespace hearth
