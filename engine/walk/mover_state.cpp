#include "walk/mover_state.h"

#include <algorithm>
#include <cmath>

#include "walk/walk_input.h"

namespace hearth {

namespace {

/// Ticks until it leaves the end where it rests; none if it stays.
std::optional<double> ticksOfRest(const Mover& mover, double share) {
  const bool isLoop = mover.trigger == MoverTrigger::Loop;
  if (!isLoop && (share < 1 || !mover.wait)) return std::nullopt;
  return std::round(mover.wait.value_or(0) * kTicksPerSecond);
}

MoverState rested(const Mover& mover, MoverState state) {
  const std::optional<double> ticks = ticksOfRest(mover, state.share);
  if (!ticks) return state;
  if (state.rested + 1 < *ticks) {
    ++state.rested;
    return state;
  }
  return {state.share, state.share < 1 ? 1 : -1, 0};
}

}  // namespace

MoverState firstState(const Mover& mover) {
  return {0, mover.trigger == MoverTrigger::Loop ? 1 : 0, 0};
}

MoverState started(const Mover& mover, MoverState state) {
  if (mover.trigger == MoverTrigger::Loop) return state;
  return {state.share, state.share < 1 ? 1 : 0, 0};
}

MoverState moved(const Mover& mover, double distance, MoverState state) {
  if (state.direction == 0) return rested(mover, state);
  const double end = state.direction > 0 ? 1 : 0;
  const double step = mover.speed / kTicksPerSecond / distance;  // infinite between equal ends
  if (!(std::abs(end - state.share) > step)) return {end, 0, 0};
  return {state.share + state.direction * step, state.direction, 0};
}

}  // namespace hearth
