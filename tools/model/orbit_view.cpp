#include "model/orbit_view.h"

#include <algorithm>
#include <cmath>

#include "math/trig.h"
#include "model/model_air.h"
#include "render/camera.h"

namespace hearth {

namespace {

/// The part of the picture's width and height that the model takes at most.
constexpr double kFilled = 0.9;

constexpr double kFrontAngle = 270;  // along -y
constexpr double kFrontPitch = -20;

/// Towards what a camera looks at, in a picture that shears: of length 1 on the plan.
Vec3 lookAlong(double angle, double pitch) {
  const SinCos turn = sinCosDegrees(angle);
  return {turn.cos, turn.sin, tanDegrees(pitch)};
}

}  // namespace

Vec3 OrbitView::eye() const { return target - distance * lookAlong(angle, pitch); }

FrontView::FrontView(const Box3& box, double fov, ImageSize size)
    : view_{centreOf(box), 0, kFrontAngle, kFrontPitch},
      halfWidth_(kFilled * tanDegrees(fov / 2)),
      halfHeight_(halfWidth_ * size.height / size.width),
      farthest_(kFarthestRadii * radiusOf(box)) {}

/// A point `ahead`, `aside` and `up` of the target, in metres, has the depth `distance + ahead`. In
/// the picture it is `aside / depth` beside the middle and `(up - slope * ahead) / depth` above it,
/// in distances of the picture plane: looking up and down only shears.
void FrontView::add(Vec3 point) {
  const Vec3 look = lookAlong(view_.angle, view_.pitch);
  const Vec3 from = point - view_.target;
  const double ahead = dot(from.xy(), look.xy());
  const double aside = std::abs(dot(from.xy(), turned90(look.xy())));
  const double above = std::abs(from.z - look.z * ahead);
  const double distance = std::max(aside / halfWidth_, above / halfHeight_) - ahead;
  view_.distance = std::min(std::max(view_.distance, distance), farthest_);
}

OrbitView frontView(std::span<const MeshFace> faces, double fov, ImageSize size) {
  FrontView front(boxOf(faces), fov, size);
  for (const MeshFace& face : faces)
    for (const Vec3& corner : face.corners) front.add(corner);
  return front.view();
}

Box3 boxOf(std::span<const MeshFace> faces) {
  Box3 box;
  for (const MeshFace& face : faces)
    for (const Vec3& corner : face.corners) box.add(corner);
  return box;
}

OrbitView viewFrom(const Camera& camera, const Box3& box) {
  const Vec3 look = lookAlong(camera.angle, camera.pitch);
  const double distance = dot(centreOf(box) - camera.eye, look) / dot(look, look);
  OrbitView view{{}, distance > 0 ? distance : radiusOf(box), camera.angle, camera.pitch};
  view.target = camera.eye + view.distance * look;
  return view;
}

}  // namespace hearth
