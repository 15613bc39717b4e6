#include "level/mover.h"

#include <algorithm>
#include <numeric>

namespace hearth {

std::string_view name(FlatPart part) { return kFlatPartNames[static_cast<std::size_t>(part)]; }

std::string_view name(MoverTrigger trigger) {
  return kMoverTriggerNames[static_cast<std::size_t>(trigger)];
}

std::vector<RestState> restStatesAround(std::span<const double> shares) {
  std::vector<std::size_t> falling(shares.size());
  std::iota(falling.begin(), falling.end(), std::size_t{0});
  std::ranges::stable_sort(falling, std::ranges::greater{},
                           [&](std::size_t mover) { return shares[mover]; });
  std::vector<RestState> states;
  RestState state{std::vector<double>(shares.size()), 0};
  double before = 1;
  const auto addUpTo = [&](double share) {
    state.weight = before - share;
    if (state.weight > 0) states.push_back(state);
    before = share;
  };
  for (const std::size_t mover : falling) {
    addUpTo(shares[mover]);
    state.shares[mover] = 1;
  }
  addUpTo(0);
  return states;
}

}  // namespace hearth
