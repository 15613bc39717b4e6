#include "level/mover.h"

#include <algorithm>
#include <numeric>

namespace hearth {

std::string_view name(FlatPart part) { return kFlatPartNames[static_cast<std::size_t>(part)]; }

std::string_view name(MoverTrigger trigger) {
  return kMoverTriggerNames[static_cast<std::size_t>(trigger)];
}

void RestStates::find(std::span<const double> shares) {
  falling_.resize(shares.size());
  std::iota(falling_.begin(), falling_.end(), std::size_t{0});
  std::ranges::sort(falling_, [&](std::size_t a, std::size_t b) {
    return shares[a] != shares[b] ? shares[a] > shares[b] : a < b;
  });
  atEnd_.clear();
  weights_.clear();
  atEnd_.reserve(shares.size() + 1);
  weights_.reserve(shares.size() + 1);
  double before = 1;
  for (std::size_t i = 0; i <= falling_.size(); ++i) {
    const double share = i < falling_.size() ? shares[falling_[i]] : 0;
    if (before > share) {
      atEnd_.push_back(i);
      weights_.push_back(before - share);
    }
    before = share;
  }
}

std::vector<double> RestStates::shares(std::size_t state) const {
  std::vector<double> shares(falling_.size());
  for (std::size_t i = 0; i < atEnd_[state]; ++i) shares[falling_[i]] = 1;
  return shares;
}

}  // namespace hearth
