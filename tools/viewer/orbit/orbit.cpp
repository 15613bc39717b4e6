#include "viewer/orbit/orbit.h"

#include <algorithm>
#include <cmath>

#include "math/trig.h"
#include "model/model_air.h"
#include "render/camera.h"

namespace hearth {

namespace {

/// In radii of the model's box.
constexpr double kNearestRadii = 0.02;

/// Eyes keep this far off the borders of the air, beyond which rounding may lead; in radii.
constexpr double kRimRadii = 1e-3;

/// Where eyes may be.
Box3 airWithoutRim(const Box3& model) {
  const double rim = kRimRadii * radiusOf(model);
  Box3 air = airRound(model);
  air.min = air.min + Vec3{rim, rim, rim};
  air.max = air.max - Vec3{rim, rim, rim};
  return air;
}

Vec3 movedInto(const Box3& box, Vec3 p) {
  return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y),
          std::clamp(p.z, box.min.z, box.max.z)};
}

}  // namespace

void Orbit::tick(const OrbitInput& input) {
  previous_ = current_;
  current_.angle = wrappedDegrees(current_.angle + input.turn);
  current_.pitch = std::clamp(current_.pitch - input.tilt, -kMaxPitch, kMaxPitch);
  // A camera that was placed nearer or farther than these limits goes no farther beyond them.
  const double radius = radiusOf(model_);
  const double nearest = std::min(kNearestRadii * radius, current_.distance);
  const double farthest = std::max(kFarthestRadii * radius, current_.distance);
  current_.distance = std::clamp(input.zoom * current_.distance, nearest, farthest);
}

bool Orbit::continueIn(const Box3& model) {
  model_ = model;
  show(current_);
  return movedInto(airWithoutRim(model), current_.eye()) == current_.eye();
}

OrbitView Orbit::at(double fraction) const {
  const double turn = std::remainder(current_.angle - previous_.angle, 360.0);
  return {previous_.target + fraction * (current_.target - previous_.target),
          std::lerp(previous_.distance, current_.distance, fraction),
          wrappedDegrees(previous_.angle + fraction * turn),
          std::lerp(previous_.pitch, current_.pitch, fraction)};
}

Vec3 Orbit::eyeAt(double fraction) const {
  return movedInto(airWithoutRim(model_), at(fraction).eye());
}

}  // namespace hearth
