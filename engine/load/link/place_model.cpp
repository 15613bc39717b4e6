#include "load/link/place_model.h"

#include <cmath>
#include <cstddef>

#include "load/json/fields.h"

namespace hearth {

MeshFace ModelPlacement::operator()(const ModelFace& face) const {
  MeshFace inLevel;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    inLevel.corners[i] = placed(face.corners[i]);
    inLevel.image[i] = {face.image[i].x, 1 - face.image[i].y};
  }
  return inLevel;
}

Vec3 ModelPlacement::placed(Vec3 corner) const {
  const Vec3 p = inOtherAxes(corner);
  const Vec2 plan{p.x * scale_.x, p.y * scale_.y};
  return position_ + Vec3{turn_.cos * plan.x - turn_.sin * plan.y,
                          turn_.sin * plan.x + turn_.cos * plan.y, p.z * scale_.z};
}

bool hasArea(const MeshFace& face) { return length(frontOf(face)) > 0; }

bool isInReach(Vec3 corner) {
  const auto isInside = [](double coordinate) { return std::abs(coordinate) <= kWorldLimit; };
  return isInside(corner.x) && isInside(corner.y) && isInside(corner.z);  // none is NaN
}

}  // namespace hearth
