#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "render/segment_columns.h"
#include "render/strip.h"

namespace hearth {

/// Numbers of items by the strips that they may show in. Takes memory for the strips between the
/// first and the last of them alone, and keeps it from frame to frame.
class ByStrip {
 public:
  /// Sorts items [0, count), of which each has columns `columnsOf(i)`, at least one.
  template <typename ColumnsOf>
  void sort(std::size_t count, ColumnsOf&& columnsOf);

  /// Those of a strip, rising.
  std::span<const std::uint32_t> in(int strip) const {
    const int i = strip - firstStrip_;
    if (i < 0 || i + 1 >= static_cast<int>(begins_.size())) return {};
    const std::uint32_t begin = begins_[static_cast<std::size_t>(i)];
    return std::span(items_).subspan(begin, begins_[static_cast<std::size_t>(i) + 1] - begin);
  }

 private:
  int firstStrip_ = 0;
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> begins_;  ///< strip i has items_[begins_[i] ... begins_[i + 1])
};

/// By counting.
template <typename ColumnsOf>
void ByStrip::sort(std::size_t count, ColumnsOf&& columnsOf) {
  ColumnRange all{std::numeric_limits<int>::max(), 0};
  for (std::size_t i = 0; i < count; ++i) {
    const ColumnRange columns = columnsOf(i);
    all = {std::min(all.begin, columns.begin), std::max(all.end, columns.end)};
  }
  begins_.clear();
  if (count == 0) return;
  firstStrip_ = all.begin / Strip::kColumns;
  begins_.resize(static_cast<std::size_t>(Strip::countIn(all.end) - firstStrip_) + 1);
  const auto visitStrips = [&](std::size_t i, auto&& visit) {
    const ColumnRange columns = columnsOf(i);
    const int end = Strip::countIn(columns.end);
    for (int strip = columns.begin / Strip::kColumns; strip < end; ++strip)
      visit(begins_[static_cast<std::size_t>(strip - firstStrip_)]);
  };
  for (std::size_t i = 0; i < count; ++i) visitStrips(i, [](std::uint32_t& size) { ++size; });
  std::uint32_t end = 0;
  for (std::uint32_t& begin : begins_) begin = end += begin;
  items_.resize(end);
  // From the last item on, each strip's begin moves down from its end.
  for (std::size_t i = count; i-- > 0;)
    visitStrips(i, [&](std::uint32_t& begin) { items_[--begin] = static_cast<std::uint32_t>(i); });
}

}  // namespace hearth
