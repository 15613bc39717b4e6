#pragma once

#include "math/vec.h"

namespace hearth {

/// The disc of a sun, infinitely far away. A point sees it where the straight line towards it ends
/// in the sky.
class Sun {
 public:
  /// In degrees: where one looks to see its middle, `angle` 0 along +x and 90 along +y, `pitch` up;
  /// `size` is its diameter, 0 <= size < 180, and 0 makes it a point.
  Sun(double angle, double pitch, double size);

  double angle() const { return angle_; }
  double pitch() const { return pitch_; }
  double size() const { return size_; }

  /// Towards its middle, of length 1.
  Vec3 direction() const { return direction_; }
  /// Of the angle between its middle and its rim.
  double sinRadius() const { return sinRadius_; }
  double cosRadius() const { return cosRadius_; }

  friend bool operator==(const Sun&, const Sun&) = default;

 private:
  double angle_;
  double pitch_;
  double size_;
  Vec3 direction_;
  double sinRadius_;
  double cosRadius_;
};

}  // namespace hearth
