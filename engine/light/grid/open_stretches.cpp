#include "light/grid/open_stretches.h"

#include <algorithm>
#include <array>
#include <span>
#include <variant>

#include "math/tolerance.h"

namespace hearth {

namespace {

/// Heights along a segment, linear between its ends.
struct AirOver {
  AirColumn at0;
  AirColumn at1;
};

/// Cuts off where the clearance, in metres and linear along the segment, is negative.
void keepClear(OpenStretch& open, double clearance0, double clearance1) {
  if (clearance0 < 0 && clearance1 < 0) open.end = open.begin;
  if ((clearance0 < 0) == (clearance1 < 0)) return;
  const double crossing = clearance0 / (clearance0 - clearance1);
  if (clearance0 < 0) open.begin = std::max(open.begin, crossing);
  if (clearance1 < 0) open.end = std::min(open.end, crossing);
}

/// Cuts off where a bottom of any of them is not below a top of any.
void keepOpen(OpenStretch& open, std::span<const AirOver> airs) {
  for (const AirOver& a : airs)
    for (const AirOver& b : airs)
      keepClear(open, b.at0.zTop - a.at0.zBottom - kHeightNoise,
                b.at1.zTop - a.at1.zBottom - kHeightNoise);
}

/// Cuts off where the air of one does not reach the foot (head) of the other's, within `noise`.
void keepAtFoot(OpenStretch& open, const AirOver& air, const AirOver& near, bool floor,
                double noise) {
  const auto clearance = [floor, noise](AirColumn some, AirColumn whole) {
    const double step = floor ? some.zBottom - whole.zBottom : whole.zTop - some.zTop;
    return noise - step;
  };
  keepClear(open, clearance(air.at0, near.at0), clearance(air.at1, near.at1));
}

}  // namespace

std::vector<OpenStretch> openAtFoot(const Scene& scene, const Segment& segment, bool floor) {
  const SegmentGeometry& own = scene.geometryOf(segment);
  const AirOver near = {own.air0, own.air1};
  std::vector<OpenStretch> found;
  for (const WallPiece& piece : scene.piecesOf(segment)) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    if (!opening) continue;
    const SegmentGeometry& far = scene.geometryOf(scene[opening->twin]);
    const AirColumn range = {piece.zBottom, piece.zTop};
    const std::array<AirOver, 3> airs = {{near, {range, range}, {far.air1, far.air0}}};
    OpenStretch open{opening->next, 0, 1};
    keepOpen(open, airs);
    for (const AirOver& air : airs) keepAtFoot(open, air, near, floor, noiseOf(segment.length));
    if (open.begin < open.end) found.push_back(open);
  }
  return found;
}

}  // namespace hearth
