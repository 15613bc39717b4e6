// Compiled once for each instruction set, as pixel_kernels.cpp is.

#include "render/face_cover.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/face_cover.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstddef>
#include <limits>
#include <utility>

#include "math/tolerance.h"
#include "render/lane_registers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

constexpr std::size_t kColumns = Strip::kColumns;

/// Rows [begin, end) of some neighbouring lanes: whole numbers, begin <= end.
struct RayRows {
  Doubles begin;
  Doubles end;
};

/// Those that a face covers.
HWY_INLINE RayRows rowsOf(const FaceFront& front, const AirRays& rays, Doubles slants,
                          RayRows rows) {
  for (const Vec3 edge : front.edges) {
    const Doubles level = hn::Add(all(edge.x), hn::Mul(slants, all(edge.y)));
    if (edge.z == 0) {
      // Upright: what is exactly on a left edge is inside.
      const DoubleMask out = edge.y <= 0 ? hn::Le(level, all(0)) : hn::Lt(level, all(0));
      rows.end = hn::IfThenElse(out, rows.begin, rows.end);
      continue;
    }
    const Doubles slope = hn::Div(hn::Neg(level), all(edge.z));
    const Doubles row = hn::Sub(all(rays.horizonRow), hn::Mul(slope, all(rays.distancePx)));
    const Doubles first = hn::Ceil(hn::Min(hn::Max(hn::Sub(row, all(0.5)), rows.begin), rows.end));
    (edge.z > 0 ? rows.end : rows.begin) = first;
  }
  return rows;
}

/// Of these lanes, those in the face's columns.
HWY_INLINE DoubleMask hasColumns(const FaceFront& front, const AirRays& rays, std::size_t lane) {
  const Doubles columns = hn::Iota(kDouble, rays.firstColumn + static_cast<double>(lane));
  return hn::And(hn::Ge(columns, all(front.columns.begin)),
                 hn::Lt(columns, all(front.columns.end)));
}

/// The rows that a face covers in all lanes; returns the first and the end of all.
HWY_INLINE std::pair<int, int> findRows(const FaceFront& front, const AirRays& rays,
                                        LaneDoubles& begins, LaneDoubles& ends) {
  Doubles first = all(std::numeric_limits<double>::max());
  Doubles last = all(0);
  for (std::size_t lane = 0; lane < kColumns; lane += hn::Lanes(kDouble)) {
    const Doubles begin = hn::Load(kDouble, &rays.begins[lane]);
    const Doubles end =
        hn::IfThenElse(hasColumns(front, rays, lane), hn::Load(kDouble, &rays.ends[lane]), begin);
    const RayRows rows = rowsOf(front, rays, hn::Load(kDouble, &rays.slants[lane]), {begin, end});
    hn::Store(rows.begin, kDouble, &begins[lane]);
    hn::Store(rows.end, kDouble, &ends[lane]);
    const DoubleMask covered = hn::Lt(rows.begin, rows.end);
    first = hn::Min(first, hn::IfThenElse(covered, rows.begin, first));
    last = hn::Max(last, hn::IfThenElseZero(covered, rows.end));
  }
  const double end = hn::GetLane(hn::MaxOfLanes(kDouble, last));
  if (end <= 0) return {0, 0};
  return {static_cast<int>(hn::GetLane(hn::MinOfLanes(kDouble, first))), static_cast<int>(end)};
}

void cover(const FaceFront& front, NearestFaces::Number number, const AirRays& rays,
           NearestFaces& nearest) {
  LaneDoubles begins;
  LaneDoubles ends;
  const auto [firstRow, lastRow] = findRows(front, rays, begins, ends);
  if (firstRow >= lastRow) return;
  nearest.reach(firstRow, lastRow);
  for (std::size_t lane = 0; lane < kColumns; lane += hn::Lanes(kDouble)) {
    const Doubles begin = hn::Load(kDouble, &begins[lane]);
    const Doubles end = hn::Load(kDouble, &ends[lane]);
    if (hn::AllFalse(kDouble, hn::Lt(begin, end))) continue;
    const Doubles level =
        hn::Add(all(front.nearness.x),
                hn::Mul(hn::Load(kDouble, &rays.slants[lane]), all(front.nearness.y)));
    const Doubles least = hn::Load(kDouble, &rays.least[lane]);
    const Doubles most = hn::Load(kDouble, &rays.most[lane]);
    const Doubles floorRise = hn::Load(kDouble, &rays.floorRises[lane]);
    const Doubles ceilingRise = hn::Load(kDouble, &rays.ceilingRises[lane]);
    for (int row = firstRow; row < lastRow; ++row) {
      NearestFaces::Row& pixels = nearest[row];
      const Doubles raySlope = all(rays.raySlopes[row]);
      const Doubles nearness = hn::Add(level, hn::Mul(raySlope, all(front.nearness.z)));
      const Doubles before = hn::Load(kDouble, &pixels.nearness[lane]);
      const DoubleMask isCovered = hn::And(hn::Ge(all(row), begin), hn::Lt(all(row), end));
      const DoubleMask isNearer = hn::Ge(nearness, hn::Mul(before, all(1 - kNearTie)));
      const DoubleMask isBetween = hn::And(hn::Ge(nearness, least), hn::Le(nearness, most));
      const DoubleMask isAboveFloor =
          hn::Ge(hn::Add(hn::Mul(all(rays.floorBelow), nearness), raySlope), floorRise);
      const DoubleMask isBelowCeiling =
          hn::Ge(hn::Add(hn::Mul(all(rays.ceilingAbove), nearness), ceilingRise), raySlope);
      const DoubleMask shows = hn::And(hn::And(isCovered, isNearer),
                                       hn::And(isBetween, hn::And(isAboveFloor, isBelowCeiling)));
      // Whole registers: on AMD's Zen, masked stores of AVX2 took two fifths of this function.
      const auto face = hn::IfThenElse(hn::RebindMask(kLongWord, shows), hn::Set(kLongWord, number),
                                       hn::Load(kLongWord, &pixels.faces[lane]));
      hn::Store(hn::IfThenElse(shows, nearness, before), kDouble, &pixels.nearness[lane]);
      hn::Store(face, kLongWord, &pixels.faces[lane]);
    }
  }
}

CoverFace coverFaceHere() { return cover; }

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hearth {

namespace {
HWY_EXPORT(coverFaceHere);
}

CoverFace coverFace() { return HWY_DYNAMIC_DISPATCH(coverFaceHere)(); }

}  // namespace hearth

#endif
