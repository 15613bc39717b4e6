#pragma once

#include <span>
#include <vector>

namespace hearth {

/// A cost and an error. Less of each is better.
struct CostAndError {
  double cost = 0;
  double error = 0;
};

/// Which of them are on the Pareto front: no other is better in one and at least as good in the
/// other.
std::vector<bool> onParetoFront(std::span<const CostAndError> all);

}  // namespace hearth
