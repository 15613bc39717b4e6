#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "level/mesh.h"
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

    /// Where it counts if backs do so much nearer.
    double place(double backsNearer) const { return isFront ? t : t - backsNearer; }
  };
  /// Edges belong to a face. None of a face that the ray sees edge-on.
  std::optional<Crossing> crossingOf(const MeshFace& face) const;

  /// Whether the ray meets a face between two parameters, both included, and beyond its origin.
  bool meets(const MeshFace& face, double tFrom, double tTo) const {
    const std::optional<Crossing> crossing = crossingOf(face);
    return crossing && crossing->t >= tFrom && crossing->t <= tTo && crossing->t > 0;
  }

  Vec3 origin() const { return origin_; }
  /// The ray parameter of one metre along each axis; endless along those that it runs across.
  Vec3 perUnit() const { return perUnit_; }

 private:
  struct Place {
    Vec2 aside;    ///< from the ray, along the other two axes
    double along;  ///< the axis of its largest component, from the origin
  };
  Place placeOf(Vec3 p) const {
    const Vec3 offset = p - origin_;
    const double along = offset.*along_;
    return {{offset.*right_ - along * shear_.x, offset.*up_ - along * shear_.y}, along};
  }

  Vec3 origin_;
  Vec3 perUnit_;
  double Vec3::*along_;
  double Vec3::*right_;
  double Vec3::*up_;
  Vec2 shear_;
  double perAlong_;
};

// Inline: most of the time that rays take at a mesh is spent here.
inline std::optional<FaceRay::Crossing> FaceRay::crossingOf(const MeshFace& face) const {
  const std::array<Place, 3> places{placeOf(face.corners[0]), placeOf(face.corners[1]),
                                    placeOf(face.corners[2])};
  const double weight0 = cross(places[1].aside, places[2].aside);
  const double weight1 = cross(places[2].aside, places[0].aside);
  const double weight2 = cross(places[0].aside, places[1].aside);
  const double least = std::min(std::min(weight0, weight1), weight2);
  const double most = std::max(std::max(weight0, weight1), weight2);
  if (least < 0 && most > 0) return std::nullopt;
  const double sum = weight0 + weight1 + weight2;
  if (!(std::abs(sum) > 0)) return std::nullopt;
  const double along =
      (weight0 * places[0].along + weight1 * places[1].along + weight2 * places[2].along) / sum;
  return Crossing{along * perAlong_, sum > 0};
}

}  // namespace hearth
