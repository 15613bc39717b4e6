#pragma once

#include "level/ids.h"

namespace hearth {

/// Rows [rowBegin, rowEnd) of one column that show one surface.
struct Span {
  int column;
  int rowBegin;
  int rowEnd;
  SurfaceId surface;
  /// Depth in metres at which the column leaves the sector: the depth of an upright surface, and
  /// the greatest depth of a flat or slope.
  double depth;
  double s = 0;         ///< upright: metres along the authored wall, for the texture
  double fraction = 0;  ///< upright: of the way from the segment's p0 to p1
  double zRef = 0;      ///< upright: the absolute height at which v is 0
};

}  // namespace hearth
