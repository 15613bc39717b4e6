#include "walk/bob.h"

#include <algorithm>
#include <cmath>

#include "math/trig.h"
#include "walk/body.h"

namespace hearth {

namespace {

/// In a level for larger or smaller bodies steps are so, too: two of them, one up and down, are as
/// long as the eye is high, and running lifts it by a 25th of that, 6 cm of 1.6 m.
constexpr double kLiftOfEyeHeight = 1.0 / 25;

constexpr double kFullSwing = 5;   // m/s, running
constexpr double kGrip = 1.0 / 8;  // fraction of what the swing lacks that a tick makes up for

double eyeHeight(const Scene& scene) { return bodyOf(scene.level(), 0).eyeHeight; }

}  // namespace

Gait walkedOn(const Gait& gait, const Walker& before, const Walker& after) {
  const double metres = after.isOnGround ? length(after.feet.xy() - before.feet.xy()) : 0;
  const double swing = std::min(1.0, metres * kTicksPerSecond / kFullSwing);
  return {gait.stride + metres, gait.swing + kGrip * (swing - gait.swing)};
}

Eye bobbed(const Scene& scene, const Eye& eye, const Gait& gait, double strength) {
  const double height = eyeHeight(scene);
  const double turn = 360 * std::fmod(gait.stride / height, 1.0);
  const double lift = strength * gait.swing * kLiftOfEyeHeight * height * sinCosDegrees(turn).sin;
  const Vec2 p = eye.point.xy();
  const Sector& sector = scene[eye.sector];
  Eye lifted = eye;
  lifted.point.z =
      std::max(scene.airBottom(sector, p), std::min(eye.point.z + lift, scene.airTop(sector, p)));
  return lifted;
}

}  // namespace hearth
