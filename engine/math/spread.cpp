#include "math/spread.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hearth {

Spread spreadOf(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double fraction) {
    const auto index = std::ceil(fraction * static_cast<double>(values.size())) - 1;
    return values[static_cast<std::size_t>(std::max(0.0, index))];
  };
  return {at(0.5), at(0.95)};
}

}  // namespace hearth
