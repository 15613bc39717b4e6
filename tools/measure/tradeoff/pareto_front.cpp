#include "measure/tradeoff/pareto_front.h"

#include <algorithm>

namespace hearth {

std::vector<bool> onParetoFront(std::span<const CostAndError> all) {
  const auto isBetter = [](const CostAndError& a, const CostAndError& b) {
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
  };
  std::vector<bool> found;
  for (const CostAndError& one : all)
    found.push_back(
        std::ranges::none_of(all, [&](const CostAndError& other) { return isBetter(other, one); }));
  return found;
}

}  // namespace hearth
