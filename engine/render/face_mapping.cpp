#include "render/face_mapping.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/face_gradient.h"

namespace hearth {

namespace {

/// How far the eye is before the plane, in the units of `out`.
double eyeBefore(const MeshFace& face, Vec3 out, Vec3 eye) {
  return dot(out, eye - face.corners[0]);
}

/// Whether a plane is so steep that the depth along a column is constant, to less than a millionth
/// of it. What is less steep keeps half of a double's digits for the place in that depth.
bool isUprightPlane(Vec3 out) {
  constexpr double kSteep = 1e-8;
  return std::abs(out.z) <= kSteep * length(out.xy());
}

}  // namespace

const FacePlaces* placesOf(const Level& level, const LitMesh* mesh, const MeshFace& face) {
  if (!mesh) return nullptr;
  const std::uint32_t first = level.meshOf(mesh->surface).firstFace;
  return &mesh->places[level.indexOf(face) - first];
}

void mapFace(const Projection& projection, const SpanGroup& group, const Texture* image,
             const FacePlaces* places, GroupMapping& mapping) {
  const MeshFace& face = *group.face;
  const Vec3 eye = projection.eye();
  const Vec3 out = frontOf(face);
  mapping.isPlane = !isUprightPlane(out);
  mapping.isOfFace = true;
  std::array<Vec3, Strip::kColumns> rays;  // 1 m deep; of planes along these
  for (std::size_t lane = 0; lane < rays.size(); ++lane) {
    const Vec2 ray = projection.rayOf(group.firstColumn + static_cast<int>(lane) + 0.5);
    mapping.rise[lane] = mapping.isPlane ? -dot(out.xy(), ray) / out.z : 0;
    rays[lane] = {ray.x, ray.y, mapping.rise[lane]};
  }
  mapping.height = mapping.isPlane ? -eyeBefore(face, out, eye) / out.z : 0;
  const auto map = [&](const std::array<Vec2, 3>& corners, double Vec2::*axis, LaneAffine& to) {
    const auto& [a, b, c] = corners;
    const FaceGradient gradient = gradientOf(face.corners, eye, {a.*axis, b.*axis, c.*axis});
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
      const double along = dot(gradient.perMetre, rays[lane]);
      // Along what is upright the parameter is the slope of the ray.
      to.atZero[lane] = mapping.isPlane ? gradient.atEye + mapping.height * gradient.perMetre.z
                                        : gradient.atEye + group.depth[lane] * along;
      to.per[lane] = mapping.isPlane ? along : group.depth[lane] * gradient.perMetre.z;
    }
  };
  const auto mapImage = [&](double Vec2::*axis, int size, LaneImageAxis& to) {
    map(face.image, axis, to.place);
    to.origin.fill(0);
    to.texelsPerPlace = size;
    to.offset = 0;
  };
  if (image) {
    mapImage(&Vec2::x, image->width(), mapping.u);
    mapImage(&Vec2::y, image->height(), mapping.v);
  }
  if (places) {
    map(*places, &Vec2::x, mapping.s);
    map(*places, &Vec2::y, mapping.t);
  }
}

double repeatsOfPixel(const Projection& projection, const MeshFace& face) {
  // A pixel w metres wide at 1 m covers w^2 d^3 / h of a plane that is h metres before the eye.
  const double w = 1 / projection.distancePx();
  const Vec2 edge1 = face.image[1] - face.image[0];
  const Vec2 edge2 = face.image[2] - face.image[0];
  // Both are of twice the face's area, which cancels out.
  const double repeats = std::abs(cross(edge1, edge2));
  return w * w * repeats / std::abs(eyeBefore(face, frontOf(face), projection.eye()));
}

}  // namespace hearth
