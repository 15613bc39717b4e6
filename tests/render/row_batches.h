#pragma once

#include <algorithm>
#include <vector>

#include "render/row_batch.h"

namespace hearth::test {

/// Makes a batch of rows with these parameters, at most RowBatch::kRows.
inline void setRows(RowBatch& batch, const std::vector<double>& parameters) {
  batch.count = parameters.size();
  std::ranges::copy(parameters, batch.depths.begin());
  batch.parameters = batch.depths.data();
}

}  // namespace hearth::test
