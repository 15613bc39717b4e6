#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "render/column_hits.h"
#include "render/span.h"
#include "render/strip.h"

namespace hearth {

/// The spans of some of a frame's columns by the strips that they lie in. Keeps its memory from
/// frame to frame.
class StripSpans {
 public:
  /// Counts the spans of each strip, and puts them where those of the strips before end. `columns`
  /// begin with a strip.
  void sort(std::span<const Span> spans, ColumnRange columns) {
    firstStrip_ = columns.begin / Strip::kColumns;
    begin_.assign(static_cast<std::size_t>(Strip::countIn(columns.end - columns.begin)) + 2, 0);
    for (const Span& span : spans) ++begin_[stripOf(span) + 2];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    sorted_.resize(spans.size());
    for (const Span& span : spans) sorted_[begin_[stripOf(span) + 1]++] = span;
  }

  /// Those of one strip of the frame, in the order in which they were found.
  std::span<const Span> of(int strip) const {
    const auto index = static_cast<std::size_t>(strip - firstStrip_);
    return std::span(sorted_).subspan(begin_[index], begin_[index + 1] - begin_[index]);
  }

 private:
  std::size_t stripOf(const Span& span) const {
    return static_cast<std::size_t>(span.column / Strip::kColumns - firstStrip_);
  }

  int firstStrip_ = 0;
  std::vector<Span> sorted_;
  std::vector<std::size_t> begin_;  ///< of the i-th are [begin_[i], begin_[i + 1])
};

}  // namespace hearth
