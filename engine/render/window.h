#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace hearth {

/// Rows [top, bottom) of one column that are still open.
struct Window {
  /// With it a list makes windows where they stay. This avoids a store-forwarding stall: a copy is
  /// a wide load right after narrow stores, and waits for them.
  Window(int atColumn, int begin, int end, double atDepth)
      : column(atColumn), top(begin), bottom(end), depth(atDepth) {}

  int column;
  int top;
  int bottom;
  double depth;  ///< metres at which the column leaves the sector in front
};

/// Lists of windows that nothing uses at the moment. Each has room for a window in every column
/// that is searched, so a viewport can get any of them.
class SpareWindows {
 public:
  std::vector<Window> take(int columns) {
    std::vector<Window> windows;
    if (!spare_.empty()) {
      windows = std::move(spare_.back());
      spare_.pop_back();
    }
    windows.reserve(static_cast<std::size_t>(columns));
    return windows;
  }
  void giveBack(std::vector<Window>&& windows) {
    windows.clear();
    spare_.push_back(std::move(windows));
  }

 private:
  std::vector<std::vector<Window>> spare_;
};

}  // namespace hearth
