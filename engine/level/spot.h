#pragma once

#include <algorithm>

#include "math/vec.h"

namespace hearth {

/// A cone of light around one direction: full up to an inner angle, none beyond an outer one, and
/// in between as smooth as Hermite's polynomial (smoothstep) of the cosine.
class Spot {
 public:
  /// In degrees: the direction, `angle` 0 along +x and 90 along +y, `pitch` up; 0 <= inner <= outer
  /// <= 180.
  Spot(double angle, double pitch, double inner, double outer);

  double angle() const { return angle_; }
  double pitch() const { return pitch_; }
  double inner() const { return inner_; }
  double outer() const { return outer_; }

  Vec3 direction() const { return direction_; }
  double cosInner() const { return cosInner_; }
  double cosOuter() const { return cosOuter_; }

  /// The factor of the light that goes out at an angle of this cosine from the direction: 0..1.
  double factor(double cosine) const {
    if (std::max(cosine, -1.0) >= cosInner_) return 1;  // whatever the rounding
    if (cosine <= cosOuter_) return 0;
    const double t = (cosine - cosOuter_) / (cosInner_ - cosOuter_);
    return t * t * (3 - 2 * t);
  }

  /// The same, of what lies at `offset` from the light; 1 at the light itself.
  double factor(Vec3 offset) const;
  /// Metres by which what lies there is outside the cone, or less; negative inside, and then from
  /// the cone's edge as far or farther. A ball around it of a smaller radius is all dark, or all
  /// lit.
  double beyondEdge(Vec3 offset) const;

  friend bool operator==(const Spot&, const Spot&) = default;

 private:
  double angle_;
  double pitch_;
  double inner_;
  double outer_;
  Vec3 direction_;
  double cosInner_;
  double cosOuter_;
  double sinOuter_;
};

}  // namespace hearth
