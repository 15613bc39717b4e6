#pragma once

#include "render/face_span.h"
#include "render/lanes.h"
#include "render/nearest_faces.h"

namespace hearth {

/// The rays of a run, which meet faces in the air of its sector.
struct AirRays {
  int firstColumn;  ///< of the strip
  LaneDoubles slants;
  // In which rows they are. Whole numbers; none in lanes that do not belong to the run.
  LaneDoubles begins{};
  LaneDoubles ends{};
  const double* raySlopes;  ///< by row
  // The first row whose ray slope is no more than some slope: horizonRow - slope * distancePx,
  // rounded up from the middle of a row.
  double horizonRow;
  double distancePx;
  // 1 / depth, per metre:
  LaneDoubles least;  ///< where they leave the sector
  LaneDoubles most;   ///< where they enter it
  // How far the floor and the ceiling are from the eye, above or below its place on the map, and
  // how they rise along the rays per metre of depth.
  double floorBelow;
  LaneDoubles floorRises;
  double ceilingAbove;
  LaneDoubles ceilingRises;
};

/// Puts a face into the pixels in which it is in the air and none of those before it is nearer: of
/// two at one depth the later stays. Works on as many columns at once as the registers of the
/// processor hold; the result is the same to the bit on every processor.
using CoverFace = void (*)(const FaceFront& front, NearestFaces::Number number, const AirRays& rays,
                           NearestFaces& nearest);

/// That for the widest registers that this processor has.
CoverFace coverFace();

}  // namespace hearth
