#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/list_per_row.h"
#include "light/polygons.h"
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

/// The texels that both have; they have some.
TexelRect intersection(const TexelRect& a, const TexelRect& b);

/// The texels that bilinear filtering can read at points of polygons, in texel coordinates.
TexelRect texelsAround(std::span<const std::vector<Vec2>> outlines);

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
  Polygons outline;  ///< of the part that bounds air, in texel coordinates
  /// All texels that bilinear filtering can read.
  TexelRect texels;
  std::vector<Continuation> continuations;

  /// Metres in front of the surface's plane.
  double distanceInFront(Vec3 p) const { return dot(p - anchor, normal); }
  /// The point of the surface's own plane at texel coordinates.
  Vec3 toWorld(Vec2 texelPoint) const {
    const Vec3 p = grid.toWorld(texelPoint);
    return p - distanceInFront(p) * normal;
  }

  /// Consecutive texels of a row.
  struct TexelRun {
    int first;
    int last;
  };
  /// The runs of texels that bilinear filtering can read in rows of `texels`, at least one in each,
  /// from left to right with gaps between them. The other texels exist because lightmaps are
  /// rectangles.
  ListPerRow<TexelRun> usedRuns(int firstRow, int rows) const;
};

/// By SurfaceId; none for skies, sprites and surfaces that do not show.
using LitSurfaces = std::vector<std::optional<LitSurface>>;

/// `texel` in metres, > 0. Grids are those of levels/README.md, "Lightmaps".
LitSurfaces makeLitSurfaces(const Scene& scene, double texel);

}  // namespace hearth
