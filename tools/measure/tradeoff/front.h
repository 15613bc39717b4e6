#pragma once

#include <span>
#include <vector>

namespace hearth {

/// What something takes, and how far off it is. Less of each is better.
struct CostAndError {
  double cost = 0;
  double error = 0;
};

/// Which of them are on the Pareto front: those to which no other is better in one and at least as
/// good in the other.
std::vector<bool> onFront(std::span<const CostAndError> all);

}  // namespace hearth
