#pragma once

#include <algorithm>

#include "level/scene.h"
#include "render/camera.h"

namespace hearth {

/// Columns [begin, end) of the screen.
struct ColumnRange {
  int begin;
  int end;
};

/// Whether they have a column in common.
constexpr bool haveCommon(ColumnRange a, ColumnRange b) {
  return std::max(a.begin, b.begin) < std::min(a.end, b.end);
}

/// The columns of a screen of this width that a segment's front covers: those whose centres lie in
/// [column of p0, column of p1). Its back covers none. Neighbours share the column of their common
/// vertex to the bit, so that every ray meets exactly one of them.
ColumnRange columnsOf(const Projection& projection, const Segment& segment, int width);

/// Where rays meet a segment.
class SegmentMeetings {
 public:
  SegmentMeetings(const Projection& projection, const Segment& segment);

  struct Meeting {
    double depth;     ///< > 0
    double fraction;  ///< 0..1 of the way from p0 to p1
  };
  /// Where the ray with this slant meets it (see Projection::slantOf).
  Meeting at(double slant) const;

 private:
  bool swapped_;
  CameraPoint a_;  ///< the ends in a fixed order, so that twins agree to the bit
  CameraPoint b_;
};

/// Where a column's ray leaves a sector.
struct ColumnHit {
  SegmentId segment;
  bool hasLevelAir;  ///< see SegmentFront
  double depth;
  double fraction;
};

}  // namespace hearth
