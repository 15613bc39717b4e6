#pragma once

#include "math/box3.h"
#include "model/orbit_view.h"

namespace hearth {

/// What the user asks of a tick, as if a hand turned the model.
struct OrbitInput {
  double turn = 0;  ///< degrees, to the right: the model's front moves to the right
  double tilt = 0;  ///< degrees, towards the eye: the model's front moves down
  double zoom = 1;  ///< factor of the distance

  friend bool operator==(const OrbitInput&, const OrbitInput&) = default;
};

/// A model that is turned, tick by tick: in truth the camera goes round it. It holds the last two
/// views, between which pictures are interpolated.
class Orbit {
 public:
  /// Of the model's box.
  Orbit(const Box3& model, const OrbitView& start)
      : model_(model), previous_(start), current_(start) {}

  void tick(const OrbitInput& input);
  /// Jumps to a view.
  void show(const OrbitView& view) { previous_ = current_ = view; }
  /// Goes on round another version of the model. Returns false if the eye is outside of its air:
  /// the caller then shows another view.
  bool continueIn(const Box3& model);

  /// The view between the previous tick (0) and the latest (1).
  OrbitView at(double fraction) const;
  /// The eye of this view, kept within the air round the model.
  Vec3 eyeAt(double fraction) const;

 private:
  Box3 model_;
  OrbitView previous_;
  OrbitView current_;
};

}  // namespace hearth
