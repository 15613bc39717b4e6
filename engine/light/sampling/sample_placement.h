#pragma once

#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"
#include "light/lit_surface.h"
#include "light/rays/id_set.h"

namespace hearth {

struct SamplePoint {
  Vec3 point;
  SurfaceId surface;  ///< on which it lies: the lightmap's, or one that continues it
  /// Where a ray to the point arrives: at the point itself, or a micrometre inside if the point
  /// lies on an edge of its surface. So rounding does not decide on which side of a wall's foot the
  /// ray arrives.
  Vec3 target;
  bool isMoved;  ///< to the surface's edge, from beyond it
  /// In a texel that nothing reads: it has the place of another sample, and needs no light.
  bool isSpare = false;
};

/// Finds where a sample of a surface's lightmap takes its light: at the sample, if it lies on the
/// surface or on a continuation; else at the nearest point of these. So nothing dark or bright
/// bleeds in from where no surface is, and no seam shows where a surface is merely cut.
///
/// A continuation counts when it is reached over common edges that are no farther from the sample
/// than the surface itself: a floor that goes on round the end of a thin wall does not count on the
/// other side of that wall. If several continuations contain the sample, because sectors overlap,
/// the one over the fewest edges counts, and of these the first in the level.
class SamplePlacement {
 public:
  /// `sought`, if any, records the surfaces on which places are sought.
  SamplePlacement(const LitSurfaces& surfaces, SurfaceId id, SurfaceSet* sought = nullptr);

  SamplePoint place(Vec2 texelPoint) const;

  /// Places points row by row, with no more of the outline than is near the row.
  class Rows;

 private:
  /// `own` is the outline of the surface, or the part of it that is near.
  SamplePoint place(Vec2 texelPoint, const Polygons& own) const;
  SamplePoint placeOutside(Vec2 texelPoint, const Polygons& own) const;
  /// The other surfaces of the plane that are joined to this one near a sample.
  using Ids = std::pmr::vector<SurfaceId>;
  Ids joinedWithin(double reach, Vec2 texelPoint, std::pmr::memory_resource& memory) const;
  Vec2 onGridOf(SurfaceId surface, Vec2 texelPoint) const;
  bool holds(const Polygons& outline, Vec2 texelPoint) const;
  /// `outline` is that of the surface, or the part of it that is near.
  SamplePoint at(SurfaceId surface, const Polygons& outline, Vec2 texelPoint, Vec2 from) const;
  Vec2 movedInside(const Polygons& outline, std::span<const Polygons::Edge> edges, Vec2 edgePoint,
                   Vec2 from) const;

  const LitSurfaces& surfaces_;
  SurfaceId id_;
  double hair_;  ///< kEdgeInset in texels
  /// Texels: edges farther away than this are more than a hair from wherever a sample is moved.
  double besideEdge_;
  SurfaceSet* sought_;
};

class SamplePlacement::Rows {
 public:
  /// Keeps a reference to `placement`.
  explicit Rows(const SamplePlacement& placement);

  /// Whose points follow. None may be farther than a few texels from its surface.
  void begin(double row);
  /// At columns in rising order.
  SamplePoint place(double column);

 private:
  const SamplePlacement& placement_;
  const LitSurface& surface_;
  double row_ = 0;
  Polygons outline_;
  std::vector<Polygons::Beside> besideEdges_;
  std::size_t next_ = 0;  ///< of these, the first that is not before the point
};

}  // namespace hearth
