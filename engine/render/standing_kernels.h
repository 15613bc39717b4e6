#pragma once

#include "render/camera.h"
#include "render/lanes.h"

namespace hearth {

/// The lower edge of an image that stands, from left to right.
struct StandingEdge {
  CameraPoint corner;
  CameraPoint along;

  /// Whether all of it is at one depth.
  bool hasOneDepth() const { return along.depth == 0; }
};

/// The rays of a run, and where they enter its sector and leave it, in metres of depth.
struct RunRays {
  LaneDoubles slants;  ///< see Projection::slantOf
  LaneDoubles entries;
  LaneDoubles exits;
};

/// Where the rays of a run meet what stands. A ray that does not meet it has the numbers of its
/// left or right edge.
struct StandingMeetings {
  LaneSet lanes;         ///< whose rays meet it before the eye and in the sector
  LaneSet atEntry;       ///< those of them that meet it where they enter the sector
  double nearest;        ///< their least depth
  LaneDoubles depth;     ///< metres
  LaneDoubles fraction;  ///< of the way from the image's left edge to the right
};

/// Loops over the columns of a run, as many at once as the registers of the processor hold. The
/// results are the same to the bit on every processor.
struct StandingKernels {
  void (*meet)(const StandingEdge& edge, const RunRays& rays, StandingMeetings& meetings);

  /// Gives rows [begin, end) to some lanes, as far as these are open there, and none to the others.
  void (*show)(int begin, int end, LaneSet lanes, const LaneRowRanges& open, LaneRowRanges& rows);
};

/// Those for the widest registers that this processor has.
const StandingKernels& standingKernels();

}  // namespace hearth
