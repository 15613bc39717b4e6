#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "render/segment_columns.h"
#include "render/span.h"
#include "render/strip.h"

namespace hearth {

/// The spans of some of a frame's columns by the strips that they lie in. Keeps its memory from
/// frame to frame.
class StripSpans {
 public:
  /// Sorts the spans by strip (a counting sort). `columns` begin with a strip.
  void sort(const VisibleSpans& found, ColumnRange columns) {
    const std::span spans(found.spans);
    const auto strips = static_cast<std::size_t>(Strip::countIn(columns.end - columns.begin));
    firstStrip_ = columns.begin / Strip::kColumns;
    begin_.assign(strips + 2, 0);
    pixels_.assign(strips, 0);
    const std::size_t withoutHoles = spans.size() - found.stats.maskedMiddleSpans;
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const std::size_t strip = stripOf(spans[i]);
      ++begin_[strip + 2];
      if (i < withoutHoles) pixels_[strip] += spans[i].rowEnd - spans[i].rowBegin;
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    sorted_.resize(spans.size());
    for (const Span& span : spans) sorted_[begin_[stripOf(span) + 1]++] = span;
  }

  /// The number of pixels of a strip that show a surface without holes: no two such spans share a
  /// pixel.
  int pixelsOf(int strip) const { return pixels_[static_cast<std::size_t>(strip - firstStrip_)]; }

  /// The spans of one strip of the frame, in the order in which they were found.
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
  std::vector<int> pixels_;         ///< by strip
};

}  // namespace hearth
