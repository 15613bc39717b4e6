#pragma once

#include <vector>

namespace hearth {

struct Spread {
  double median = 0;
  double p95 = 0;  ///< which 95 of 100 do not exceed
};

/// Of at least one value.
Spread spreadOf(std::vector<double> values);

}  // namespace hearth
