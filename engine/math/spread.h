#pragma once

#include <vector>

namespace hearth {

struct Spread {
  double median = 0;
  double p95 = 0;  ///< 95 of 100 values do not exceed it
};

/// The spread of at least one value.
Spread spreadOf(std::vector<double> values);

}  // namespace hearth
