#pragma once

#include <vector>

#include "render/row_batch.h"

namespace hearth::test {

/// A batch of the rows from 0 on, whose climbs are given; of what is upright these are the
/// measures.
inline RowBatch batchOf(const std::vector<double>& climbs, const SpanMapping& mapping = {},
                        int depthEvery = 1) {
  RowBatch batch{};
  batch.firstRow = 0;
  batch.count = climbs.size();
  findMeasures(batch, mapping, climbs, depthEvery);
  return batch;
}

}  // namespace hearth::test
