#include "level/mover.h"

#include <algorithm>
#include <numeric>

#include "math/check.h"

namespace hearth {

std::string_view name(FlatPart part) { return kFlatPartNames[static_cast<std::size_t>(part)]; }

std::string_view name(MoverTrigger trigger) {
  return kMoverTriggerNames[static_cast<std::size_t>(trigger)];
}

void RestStates::find(std::span<const double> shares, int stages) {
  CHECK(stages >= 0 && stages <= kMaxMoverStages, stages);
  steps_ = stages + 1;
  below_.resize(shares.size());
  parts_.resize(shares.size());
  falling_.resize(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double steps = shares[i] * steps_;
    below_[i] = std::min(static_cast<int>(steps), stages);
    parts_[i] = steps - below_[i];
  }
  std::iota(falling_.begin(), falling_.end(), std::size_t{0});
  std::ranges::sort(falling_, [this](std::size_t a, std::size_t b) {
    return parts_[a] != parts_[b] ? parts_[a] > parts_[b] : a < b;
  });
  atNext_.clear();
  weights_.clear();
  atNext_.reserve(shares.size() + 1);
  weights_.reserve(shares.size() + 1);
  double before = 1;
  for (std::size_t i = 0; i <= falling_.size(); ++i) {
    const double part = i < falling_.size() ? parts_[falling_[i]] : 0;
    if (before > part) {
      atNext_.push_back(i);
      weights_.push_back(before - part);
    }
    before = part;
  }
}

std::vector<double> RestStates::shares(std::size_t state) const {
  std::vector<int> stages = below_;
  for (std::size_t i = 0; i < atNext_[state]; ++i) ++stages[falling_[i]];
  std::vector<double> shares(stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) shares[i] = 1.0 * stages[i] / steps_;
  return shares;
}

}  // namespace hearth
