#pragma once

#include <algorithm>
#include <vector>

#include "render/row_batch.h"

namespace hearth::test {

/// Makes a batch of rows with these measures, at most RowBatch::kRows.
inline void setRows(RowBatch& batch, const std::vector<double>& measures) {
  batch.count = measures.size();
  std::ranges::copy(measures, batch.depths.begin());
  batch.measures = batch.depths.data();
}

}  // namespace hearth::test
