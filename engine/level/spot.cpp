#include "level/spot.h"

#include "math/check.h"
#include "math/trig.h"

namespace hearth {

Spot::Spot(double angle, double pitch, double inner, double outer)
    : angle_(angle), pitch_(pitch), inner_(inner), outer_(outer) {
  CHECK(0 <= inner && inner <= outer && outer <= 180, inner, outer);
  direction_ = directionAt(angle, pitch);
  cosInner_ = sinCosDegrees(inner).cos;
  cosOuter_ = sinCosDegrees(outer).cos;
  sinOuter_ = sinCosDegrees(outer).sin;
}

double Spot::factor(Vec3 offset) const {
  const double distance = length(offset);
  return distance > 0 ? factor(dot(offset, direction_) / distance) : 1;
}

double Spot::beyondEdge(Vec3 offset) const {
  // In the half-plane of the axis and the point, the edge of the light is a line from the light.
  const double along = dot(offset, direction_);
  const double beside = length(offset - along * direction_);
  return beside * cosOuter_ - along * sinOuter_;
}

}  // namespace hearth
