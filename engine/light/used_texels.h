#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "light/list_per_row.h"
#include "light/lit_surface.h"

namespace hearth {

/// Which texels of a rectangle bilinear filtering can read. Only these are lit. The others exist
/// because lightmaps are rectangles, and take the light of the nearest one in their row.
class UsedTexels {
 public:
  /// Of some of a surface's texels.
  UsedTexels(const LitSurface& surface, const TexelRect& rect);

  const TexelRect& rect() const { return rect_; }

  /// Calls `visit(first, last)` for those in row `j` of a part of the rectangle, run by run.
  template <typename Visit>
  void forEachRunIn(const TexelRect& part, int j, Visit&& visit) const {
    for (const auto& [first, last] : row(j)) {
      const int from = std::max(first, part.i0);
      const int to = std::min(last, part.i0 + part.width - 1);
      if (from <= to) visit(from, to);
    }
  }

  /// The number of those in a part of the rectangle.
  std::int64_t countIn(const TexelRect& part) const;
  /// The smallest rectangle around those of a part of the rectangle, if there are any.
  std::optional<TexelRect> around(const TexelRect& part) const;

  /// Calls `visit(i, used)` for each other texel of row `j`, from left to right, where its nearest
  /// used one lies in the rectangle.
  template <typename Visit>
  void forEachUnused(int j, Visit&& visit) const {
    const std::span<const LitSurface::TexelRun> runs = row(j);
    const int end = rect_.i0 + rect_.width;
    const auto visitAll = [&](int from, int to, int used) {
      if (used < rect_.i0 || used >= end) return;
      for (int i = std::max(from, rect_.i0); i < std::min(to, end); ++i) visit(i, used);
    };
    visitAll(rect_.i0, runs.front().first, runs.front().first);
    for (std::size_t k = 1; k < runs.size(); ++k) {
      const int before = runs[k - 1].last;
      const int after = runs[k].first;
      const int nearerAfter = before + (after - before + 1) / 2;  // or as near
      visitAll(before + 1, nearerAfter, before);
      visitAll(nearerAfter, after, after);
    }
    visitAll(runs.back().last + 1, end, runs.back().last);
  }

 private:
  /// At least one run.
  std::span<const LitSurface::TexelRun> row(int j) const { return runs_.row(j - rect_.j0); }

  TexelRect rect_;
  ListPerRow<LitSurface::TexelRun> runs_;
};

}  // namespace hearth
