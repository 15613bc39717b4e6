// Compiled once for each instruction set, as pixel_kernels.cpp is.

#include "render/standing_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/standing_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "math/tolerance.h"
#include "render/lane_registers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

constexpr std::size_t kStandingColumns = Strip::kColumns;
constexpr hn::CappedTag<std::int32_t, kStandingColumns> kRowNumbers;

/// Some lanes from `first` on.
HWY_INLINE unsigned lanesOf(DoubleMask mask, std::size_t first) {
  std::array<std::uint8_t, 8> bits{};  // StoreMaskBits may write so many
  hn::StoreMaskBits(kDouble, mask, bits.data());
  return static_cast<unsigned>(bits[0]) << first;
}

/// Whether a depth is less than another, or as good as equal.
HWY_INLINE DoubleMask isBefore(Doubles depth, Doubles at) {
  return hn::Le(depth, hn::Add(hn::Mul(at, all(1 + kNearTie)), all(kPositionSlack)));
}

void meetStanding(const StandingEdge& edge, const RunRays& rays, StandingMeetings& meetings) {
  unsigned lanes = 0;
  unsigned atEntry = 0;
  Doubles nearest = all(std::numeric_limits<double>::infinity());
  for (std::size_t lane = 0; lane < kStandingColumns; lane += hn::Lanes(kDouble)) {
    const Doubles slants = hn::Load(kDouble, &rays.slants[lane]);
    // How far the image's left and right edges are from the ray, to its right.
    const Doubles left = hn::Sub(all(edge.corner.lateral), hn::Mul(slants, all(edge.corner.depth)));
    const Doubles across = hn::Sub(all(edge.along.lateral), hn::Mul(slants, all(edge.along.depth)));
    const Doubles fraction = hn::Div(hn::Neg(left), across);  // beyond 0 and 1 beside the image
    const Doubles atLeast0 = hn::IfThenElseZero(hn::Gt(fraction, all(0)), fraction);
    const Doubles within = hn::IfThenElse(hn::Lt(atLeast0, all(1)), atLeast0, all(1));
    const Doubles depth = hn::Add(all(edge.corner.depth), hn::Mul(within, all(edge.along.depth)));
    const DoubleMask crosses = hn::And(hn::Ge(fraction, all(0)), hn::Lt(fraction, all(1)));
    const DoubleMask isAhead =
        hn::And(hn::Gt(depth, all(0)), isBefore(depth, hn::Load(kDouble, &rays.exits[lane])));
    const Doubles entries = hn::Load(kDouble, &rays.entries[lane]);
    const DoubleMask isPast = hn::Or(hn::Eq(entries, all(0)), hn::Not(isBefore(depth, entries)));
    const DoubleMask meets =
        hn::And(hn::And(crosses, isAhead), hn::Or(isPast, isBefore(entries, depth)));
    hn::Store(depth, kDouble, &meetings.depth[lane]);
    hn::Store(within, kDouble, &meetings.fraction[lane]);
    lanes |= lanesOf(meets, lane);
    atEntry |= lanesOf(hn::AndNot(isPast, meets), lane);
    nearest = hn::Min(nearest, hn::IfThenElse(meets, depth, nearest));
  }
  meetings.lanes = static_cast<LaneSet>(lanes);
  meetings.atEntry = static_cast<LaneSet>(atEntry);
  meetings.nearest = hn::GetLane(hn::MinOfLanes(kDouble, nearest));
}

void showStanding(int begin, int end, LaneSet lanes, const LaneRowRanges& open,
                  LaneRowRanges& rows) {
  const auto bits = hn::Set(kRowNumbers, lanes);
  for (std::size_t lane = 0; lane < kStandingColumns; lane += hn::Lanes(kRowNumbers)) {
    const auto bit =
        hn::Shl(hn::Set(kRowNumbers, 1), hn::Iota(kRowNumbers, static_cast<std::int32_t>(lane)));
    const auto shows = hn::TestBit(bits, bit);
    const auto top = hn::Load(kRowNumbers, &open.begin[lane]);
    const auto bottom = hn::Load(kRowNumbers, &open.end[lane]);
    const auto first = hn::Min(hn::Max(hn::Set(kRowNumbers, begin), top), bottom);
    const auto last = hn::Min(hn::Max(hn::Set(kRowNumbers, end), top), bottom);
    hn::Store(hn::IfThenElseZero(shows, first), kRowNumbers, &rows.begin[lane]);
    hn::Store(hn::IfThenElseZero(shows, last), kRowNumbers, &rows.end[lane]);
  }
}

const StandingKernels& standingKernelsHere() {
  static constexpr StandingKernels kKernels{meetStanding, showStanding};
  return kKernels;
}

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hearth {

namespace {
HWY_EXPORT(standingKernelsHere);
}

const StandingKernels& standingKernels() { return HWY_DYNAMIC_DISPATCH(standingKernelsHere)(); }

}  // namespace hearth

#endif
