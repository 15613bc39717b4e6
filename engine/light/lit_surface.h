#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "level/level.h"
#include "light/texel_grid.h"

namespace hearth {

/// Texels [i0, i0 + width) x [j0, j0 + height).
struct TexelRect {
  int i0 = 0;
  int j0 = 0;
  int width = 0;
  int height = 0;

  std::int64_t count() const { return std::int64_t{width} * height; }

  friend bool operator==(const TexelRect&, const TexelRect&) = default;
};

/// A surface that continues another in its plane, and the edge that they share, in texel
/// coordinates of that other one.
struct Continuation {
  SurfaceId surface;
  Vec2 edge0;
  Vec2 edge1;
};

/// A surface as the bakery and the renderer's light see it: the part of it that bounds air, on its
/// texel grid.
struct LitSurface {
  TexelGrid grid;
  Vec3 anchor;  ///< a point of the surface's own plane, which may miss the grid's by a tolerance
  Vec3 normal;  ///< unit, into the air
  /// Outlines of the part that bounds air, in texel coordinates; holes are outlines too.
  std::vector<std::vector<Vec2>> outlines;
  /// All texels that bilinear filtering can ask for.
  TexelRect texels;
  std::vector<Continuation> continuations;

  /// Metres in front of the surface's plane.
  double distanceInFront(Vec3 p) const { return dot(p - anchor, normal); }
  /// The point of the surface's own plane at texel coordinates.
  Vec3 toWorld(Vec2 texelPoint) const;
  bool contains(Vec2 texelPoint) const;
  /// The point of the outlines that is nearest.
  Vec2 nearest(Vec2 texelPoint) const;

  /// Texels.
  struct Stretch {
    double from;
    double to;
  };
  /// What of the row of points at a height lies inside, farther than `margin` texels from all
  /// edges: in rising order.
  std::vector<Stretch> insideAlong(double row, double margin) const;

  struct Edge {
    Vec2 a;
    Vec2 b;
  };
  /// Of the outlines, no farther than `reach` texels.
  std::vector<Edge> edgesWithin(Vec2 texelPoint, double reach) const;
};

/// By SurfaceId; none for sky and for surfaces of which nothing can show.
using LitSurfaces = std::vector<std::optional<LitSurface>>;

/// `texel` in metres, > 0. Grids are those of levels/README.md, "Lightmaps".
LitSurfaces makeLitSurfaces(const Level& level, double texel);

}  // namespace hearth
