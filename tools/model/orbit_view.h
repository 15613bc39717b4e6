#pragma once

#include <span>

#include "image/image.h"
#include "level/mesh.h"
#include "math/box3.h"
#include "math/vec.h"

namespace hearth {

struct Camera;

/// A camera that goes round a point and looks at it, upright.
struct OrbitView {
  Vec3 target;          ///< metres; in the middle of the picture
  double distance = 1;  ///< of the target on the plan, metres: its depth in the picture, > 0
  double angle = 0;     ///< in which the camera looks, degrees
  double pitch = 0;     ///< degrees upwards, -60..60

  Vec3 eye() const;

  friend bool operator==(const OrbitView&, const OrbitView&) = default;
};

/// Degrees: a longer lens than that of a walk, so that models are not distorted.
inline constexpr double kModelFov = 40;

/// Finds the view of a whole model that fills the picture except for a margin. The front of a model
/// looks along +z of its file, as modellers export it, which is +y of the level. The camera is in
/// front and a little above, and has the model's +x to its right.
class FrontView {
 public:
  /// Looks at the middle of the model's box. `fov` in degrees, horizontal.
  FrontView(const Box3& box, double fov, ImageSize size);

  /// Goes back until this point of the model shows, but no farther than kFarthestRadii.
  void add(Vec3 point);

  const OrbitView& view() const { return view_; }

 private:
  OrbitView view_;
  double halfWidth_;  ///< of the picture that the model may take, at a depth of 1 m
  double halfHeight_;
  double farthest_;
};

/// Of all faces of a model.
OrbitView frontView(std::span<const MeshFace> faces, double fov, ImageSize size);
Box3 boxOf(std::span<const MeshFace> faces);

/// The view that the camera has. It goes round the point in the middle of its picture that is
/// nearest to the box's centre; round one ahead if the camera looks away from the box.
OrbitView viewFrom(const Camera& camera, const Box3& box);

}  // namespace hearth
