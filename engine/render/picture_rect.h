#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "render/segment_columns.h"
#include "render/window.h"

namespace hearth {

/// Columns and rows [rowBegin, rowEnd) of a picture.
struct PictureRect {
  ColumnRange columns;
  int rowBegin;
  int rowEnd;

  /// Whether all of another one lies in it.
  bool holds(const PictureRect& other) const {
    return columns.begin <= other.columns.begin && other.columns.end <= columns.end &&
           rowBegin <= other.rowBegin && other.rowEnd <= rowEnd;
  }
};

/// The least one around windows.
inline PictureRect rectAround(std::span<const Window> windows) {
  constexpr int kMax = std::numeric_limits<int>::max();
  PictureRect around{{kMax, 0}, kMax, 0};
  for (const Window& window : windows) {
    around.columns.begin = std::min(around.columns.begin, window.column);
    around.columns.end = std::max(around.columns.end, window.column + 1);
    around.rowBegin = std::min(around.rowBegin, window.top);
    around.rowEnd = std::max(around.rowEnd, window.bottom);
  }
  return around;
}

}  // namespace hearth
