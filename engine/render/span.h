#pragma once

#include "level/ids.h"
#include "level/mesh.h"
#include "level/sprite.h"

namespace hearth {

/// Rows [rowBegin, rowEnd) of one column that show one surface.
struct Span {
  int column;
  int rowBegin;
  int rowEnd;
  SurfaceId surface;
  const SpriteView* view;  ///< what a sprite shows; null for all else
  const MeshFace* face;    ///< of a mesh; null for all else
  /// Depth in metres at which the column leaves the sector: the depth of an upright surface, and
  /// the greatest depth of a flat or slope. Likewise of a sprite or a face.
  double depth;
  /// Upright: metres along the authored wall, for the texture; of a sprite from its left edge.
  double s = 0;
  double fraction = 0;  ///< upright: of the way from the segment's p0 to p1
  double zRef = 0;      ///< upright, also a sprite: the absolute height at which v is 0
};

}  // namespace hearth
