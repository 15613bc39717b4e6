#include "walk/walk_clock.h"

#include <algorithm>
#include <cmath>

#include "walk/walk_input.h"

namespace hearth {

namespace {

/// A quarter of a second: what is made up for at once.
constexpr double kMaxTicks = kTicksPerSecond / 4.0;

}  // namespace

WalkClock::Due WalkClock::advance(double now) {
  if (!std::isfinite(now)) return {0, pendingTicks_};
  const double passed = last_ ? std::max(0.0, now - *last_) : 0;
  last_ = now;
  // A long pause is cut before it is added, so that no number of ticks can overflow.
  pendingTicks_ += std::min(kTicksPerSecond * passed, kMaxTicks + 1);
  const double whole = std::floor(pendingTicks_);
  pendingTicks_ -= whole;
  return {static_cast<int>(std::min(whole, kMaxTicks)), pendingTicks_};
}

}  // namespace hearth
