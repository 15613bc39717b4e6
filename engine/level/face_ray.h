#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "level/mesh.h"
#include "math/box3.h"
#include "math/vec.h"

namespace hearth {

/// A ray that meets faces of meshes. Faces that share corners leave no gap between them: space is
/// sheared so that the ray runs along one of its axes, each corner is rounded once, and an edge has
/// the same function, with opposite signs, in both of its faces (Woop, Benthin and Wald,
/// "Watertight Ray/Triangle Intersection", 2013).
class FaceRay {
 public:
  /// A ray along nothing meets nothing.
  FaceRay(Vec3 origin, Vec3 direction);

  struct Crossing {
    double t;      ///< ray parameter: point = origin + t * direction
    bool isFront;  ///< the ray comes from the face's front
  };
  /// Edges belong to a face. None of a face that the ray sees edge-on.
  std::optional<Crossing> crossingOf(const MeshFace& face) const;

  /// Whether the part of the ray from `tFrom` to `tTo` may meet what is in a box: true, whatever
  /// the rounding, where it does.
  bool mayMeet(const Box3& box, double tFrom, double tTo) const {
    constexpr double kSlack = 1 + 0x1p-50;  // three roundings of each end
    double tNear = tFrom;
    double tFar = tTo;
    clip(box.min.x - origin_.x, box.max.x - origin_.x, perUnit_.x, tNear, tFar);
    clip(box.min.y - origin_.y, box.max.y - origin_.y, perUnit_.y, tNear, tFar);
    clip(box.min.z - origin_.z, box.max.z - origin_.z, perUnit_.z, tNear, tFar);
    return tNear <= tFar * kSlack;
  }

 private:
  struct Place {
    Vec2 aside;    ///< from the ray, along the other two axes
    double along;  ///< the axis of its largest component, from the origin
  };
  Place placeOf(Vec3 p) const;

  /// Of a ray that runs within a side of the box the products may be no numbers, which change
  /// nothing.
  static void clip(double low, double high, double perUnit, double& tNear, double& tFar) {
    const double tLow = low * perUnit;
    const double tHigh = high * perUnit;
    tNear = std::max(tNear, perUnit < 0 ? tHigh : tLow);
    tFar = std::min(tFar, perUnit < 0 ? tLow : tHigh);
  }

  Vec3 origin_;
  Vec3 perUnit_;  ///< the ray parameter of one metre along each axis
  double Vec3::*along_;
  double Vec3::*right_;
  double Vec3::*up_;
  Vec2 shear_;
  double perAlong_;
};

}  // namespace hearth
