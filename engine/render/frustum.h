#pragma once

#include <array>
#include <cstddef>

#include "math/box3.h"
#include "render/camera.h"
#include "render/picture_rect.h"

namespace hearth {

/// What the rays of a rectangle in the picture can meet: a pyramid with its top in the eye.
class Frustum {
 public:
  Frustum(const Projection& projection, const PictureRect& rect);

  /// Whether some of a box may be inside.
  bool mayShow(const Box3& box) const;
  /// Whether all of a box is inside, ahead of the eye.
  bool holds(const Box3& box) const;

 private:
  Vec3 eye_;
  std::array<Vec3, 5> inwards_;  ///< normals of planes through the eye; the last looks ahead
};

}  // namespace hearth
