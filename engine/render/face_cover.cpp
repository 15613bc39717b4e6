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

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kColumns = Strip::kColumns;
constexpr hn::CappedTag<double, kColumns> kRays;
constexpr hn::RebindToUnsigned<decltype(kRays)> kNumbers;
using Rays = hn::Vec<decltype(kRays)>;
using RayMask = hn::Mask<decltype(kRays)>;

HWY_INLINE Rays every(double value) { return hn::Set(kRays, value); }

/// Rows [begin, end) of some neighbouring lanes: whole numbers, begin <= end.
struct RayRows {
  Rays begin;
  Rays end;
};

/// Those that a face covers.
HWY_INLINE RayRows rowsOf(const FaceFront& front, const AirRays& rays, Rays slants, RayRows rows) {
  for (const Vec3 edge : front.edges) {
    const Rays level = hn::Add(every(edge.x), hn::Mul(slants, every(edge.y)));
    if (edge.z == 0) {
      // Upright: what is exactly on a left edge is inside.
      const RayMask out = edge.y <= 0 ? hn::Le(level, every(0)) : hn::Lt(level, every(0));
      rows.end = hn::IfThenElse(out, rows.begin, rows.end);
      continue;
    }
    const Rays slope = hn::Div(hn::Neg(level), every(edge.z));
    const Rays row = hn::Sub(every(rays.horizonRow), hn::Mul(slope, every(rays.distancePx)));
    const Rays first = hn::Ceil(hn::Min(hn::Max(hn::Sub(row, every(0.5)), rows.begin), rows.end));
    (edge.z > 0 ? rows.end : rows.begin) = first;
  }
  return rows;
}

/// Of these lanes, those in the face's columns.
HWY_INLINE RayMask hasColumns(const FaceFront& front, const AirRays& rays, std::size_t lane) {
  const Rays columns = hn::Iota(kRays, rays.firstColumn + static_cast<double>(lane));
  return hn::And(hn::Ge(columns, every(front.columns.begin)),
                 hn::Lt(columns, every(front.columns.end)));
}

/// The rows that a face covers in all lanes; returns the first and the end of all.
HWY_INLINE std::pair<int, int> findRows(const FaceFront& front, const AirRays& rays,
                                        LaneDoubles& begins, LaneDoubles& ends) {
  Rays first = every(std::numeric_limits<double>::max());
  Rays last = every(0);
  for (std::size_t lane = 0; lane < kColumns; lane += hn::Lanes(kRays)) {
    const Rays begin = hn::Load(kRays, &rays.begins[lane]);
    const Rays end =
        hn::IfThenElse(hasColumns(front, rays, lane), hn::Load(kRays, &rays.ends[lane]), begin);
    const RayRows rows = rowsOf(front, rays, hn::Load(kRays, &rays.slants[lane]), {begin, end});
    hn::Store(rows.begin, kRays, &begins[lane]);
    hn::Store(rows.end, kRays, &ends[lane]);
    const RayMask covered = hn::Lt(rows.begin, rows.end);
    first = hn::Min(first, hn::IfThenElse(covered, rows.begin, first));
    last = hn::Max(last, hn::IfThenElseZero(covered, rows.end));
  }
  const double end = hn::GetLane(hn::MaxOfLanes(kRays, last));
  if (end <= 0) return {0, 0};
  return {static_cast<int>(hn::GetLane(hn::MinOfLanes(kRays, first))), static_cast<int>(end)};
}

void cover(const FaceFront& front, NearestFaces::Number number, const AirRays& rays,
           NearestFaces& nearest) {
  LaneDoubles begins;
  LaneDoubles ends;
  const auto [firstRow, lastRow] = findRows(front, rays, begins, ends);
  if (firstRow >= lastRow) return;
  nearest.reach(firstRow, lastRow);
  for (std::size_t lane = 0; lane < kColumns; lane += hn::Lanes(kRays)) {
    const Rays begin = hn::Load(kRays, &begins[lane]);
    const Rays end = hn::Load(kRays, &ends[lane]);
    if (hn::AllFalse(kRays, hn::Lt(begin, end))) continue;
    const Rays level = hn::Add(every(front.nearness.x), hn::Mul(hn::Load(kRays, &rays.slants[lane]),
                                                                every(front.nearness.y)));
    const Rays least = hn::Load(kRays, &rays.least[lane]);
    const Rays most = hn::Load(kRays, &rays.most[lane]);
    const Rays floorRise = hn::Load(kRays, &rays.floorRises[lane]);
    const Rays ceilingRise = hn::Load(kRays, &rays.ceilingRises[lane]);
    for (int row = firstRow; row < lastRow; ++row) {
      NearestFaces::Row& pixels = nearest[row];
      const Rays raySlope = every(rays.raySlopes[row]);
      const Rays nearness = hn::Add(level, hn::Mul(raySlope, every(front.nearness.z)));
      const Rays before = hn::Load(kRays, &pixels.nearness[lane]);
      const RayMask isCovered = hn::And(hn::Ge(every(row), begin), hn::Lt(every(row), end));
      const RayMask isNearer = hn::Ge(nearness, hn::Mul(before, every(1 - kNearTie)));
      const RayMask isBetween = hn::And(hn::Ge(nearness, least), hn::Le(nearness, most));
      const RayMask isAboveFloor =
          hn::Ge(hn::Add(hn::Mul(every(rays.floorBelow), nearness), raySlope), floorRise);
      const RayMask isBelowCeiling =
          hn::Ge(hn::Add(hn::Mul(every(rays.ceilingAbove), nearness), ceilingRise), raySlope);
      const RayMask shows = hn::And(hn::And(isCovered, isNearer),
                                    hn::And(isBetween, hn::And(isAboveFloor, isBelowCeiling)));
      hn::BlendedStore(nearness, shows, kRays, &pixels.nearness[lane]);
      hn::BlendedStore(hn::Set(kNumbers, number), hn::RebindMask(kNumbers, shows), kNumbers,
                       &pixels.faces[lane]);
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
