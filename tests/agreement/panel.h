#pragma once

#include <optional>
#include <vector>

#include "level/scene.h"

namespace hearth::agreement {

/// Coordinates in a plane, in metres.
struct Axes {
  Vec3 origin;
  Vec3 s;  ///< unit vectors in the plane
  Vec3 t;

  Vec2 of(Vec3 p) const { return {dot(p - origin, s), dot(p - origin, t)}; }
  Vec3 at(Vec2 st) const { return origin + st.x * s + st.y * t; }

  friend bool operator==(const Axes&, const Axes&) = default;
};

/// From a to b, with the panel in front: on the side of `turned90(b - a)`.
struct Edge {
  Vec2 a;
  Vec2 b;
};

/// Unit, at a right angle to the edge.
Vec2 inward(const Edge& edge);

/// A flat piece of the world with air before it: a polygon, which may have holes, in its plane.
struct Panel {
  SectorId sector;  ///< whose air it is
  Vec3 normal;      ///< unit, into the air
  Axes axes;
  std::vector<Edge> edges;

  /// Metres.
  double distanceInFront(Vec3 p) const { return dot(p - axes.origin, normal); }
  /// Those on an edge count as inside or not.
  bool contains(Vec2 st) const;
  /// The nearest point of the edges.
  Vec2 nearestOnEdge(Vec2 st) const;
  /// Metres from the panel; 0 inside.
  double distanceTo(Vec2 st) const;
  /// A point that is too near to an edge, or on it, moved inside until `margin` metres from all
  /// edges: all such points at the edges and corners beside it, from the nearest to `from` on. The
  /// point itself where it is far from edges, or where the panel is too narrow.
  std::vector<Vec2> movedInside(Vec2 st, double margin, Vec2 from) const;
};

/// The part of a floor or ceiling, of a slope or of an upright surface that bounds air.
Panel panelOf(const Scene& scene, SurfaceId surface);

/// All of a wall that bounds air or opens.
Panel panelOf(const Scene& scene, const Segment& wall);

}  // namespace hearth::agreement
