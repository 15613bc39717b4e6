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
  /// Metres: the depth of an upright surface or of a sprite that stands, else the greatest of the
  /// column. That of a wall, a flat or a slope is where the column leaves the sector.
  double depth;
  /// Of the way from a segment's p0 to p1, or from the left edge of a sprite that stands to the
  /// right one. Of all else it has no meaning.
  double fraction = 0;
  double zTop = 0;  ///< of a sprite that stands: the height of its upper edge
};

}  // namespace hearth
