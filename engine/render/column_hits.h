#pragma once

#include "level/level.h"
#include "render/camera.h"

namespace hearth {

/// Columns [begin, end) of the screen.
struct ColumnRange {
  int begin;
  int end;
};

/// A segment in camera space and the columns that it covers: those whose centres lie in
/// [column of p0, column of p1), or the other way round for its back. Neighbours share the column
/// of their common vertex to the bit, so that every ray meets exactly one of them.
class ProjectedSegment {
 public:
  ProjectedSegment(const Projection& projection, const Segment& segment, int width);

  enum class Facing { Front, Back };
  Facing facing() const { return facing_; }
  ColumnRange columns() const { return columns_; }  ///< empty when none

  struct Meeting {
    double depth;  ///< > 0
    double share;  ///< 0..1 of the way from p0 to p1
  };
  /// Where the ray with this slant (see Projection::slantOf) meets the segment.
  Meeting meet(double slant) const;

 private:
  CameraPoint a_;  ///< the ends in a fixed order, so that twins agree to the bit
  CameraPoint b_;
  bool swapped_;
  Facing facing_ = Facing::Front;
  ColumnRange columns_{0, 0};
};

/// Where a column's ray leaves a sector.
struct ColumnHit {
  SegmentId segment;
  double depth;
  double share;
};

}  // namespace hearth
