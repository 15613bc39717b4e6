#include "light/baking/left_out.h"

#include <cstdlib>
#include <limits>
#include <optional>

namespace hearth {

namespace {

/// A rectangle of marks.
class MarkedTexels {
 public:
  explicit MarkedTexels(const TexelRect& rect)
      : rect_(rect), isMarked_(static_cast<std::size_t>(rect.count())) {}

  void mark(int i, int j) { isMarked_[indexOf(i, j)] = true; }
  bool isInside(int i, int j) const {
    return i >= rect_.i0 && i < rect_.i0 + rect_.width && j >= rect_.j0 &&
           j < rect_.j0 + rect_.height;
  }
  bool isMarked(int i, int j) const { return isMarked_[indexOf(i, j)]; }

 private:
  std::size_t indexOf(int i, int j) const {
    return static_cast<std::size_t>(j - rect_.j0) * static_cast<std::size_t>(rect_.width) +
           static_cast<std::size_t>(i - rect_.i0);
  }

  TexelRect rect_;
  std::vector<bool> isMarked_;
};

}  // namespace

void EmptyTexels::fill(TexelSums& sums) const {
  if (texels_.empty()) return;
  MarkedTexels empty(rect_);
  for (const auto [i, j] : texels_) empty.mark(i, j);
  MarkedTexels passed = empty;
  for (const auto [i, j, used] : unused_) passed.mark(i, j);
  const int largest = std::max(rect_.width, rect_.height);
  for (const auto [i, j] : texels_) {
    std::optional<Texel> nearest;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    // Squares around the texel, until no farther one can hold a nearer texel.
    for (int ring = 1; ring < largest && std::int64_t{ring} * ring < least; ++ring)
      for (int dj = -ring; dj <= ring; ++dj)
        for (int di = -ring; di <= ring; di += std::abs(dj) == ring ? 1 : 2 * ring) {
          const std::int64_t distance = std::int64_t{di} * di + std::int64_t{dj} * dj;
          if (distance >= least || !passed.isInside(i + di, j + dj) ||
              passed.isMarked(i + di, j + dj))
            continue;
          least = distance;
          nearest = {i + di, j + dj};
        }
    if (nearest) sums.copy(nearest->i, nearest->j, i, j);
  }
  for (const auto [i, j, used] : unused_)
    if (empty.isMarked(used, j)) sums.copy(used, j, i, j);
}

}  // namespace hearth
