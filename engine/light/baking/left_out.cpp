#include "light/baking/left_out.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace hearth {

namespace {

/// A rectangle of marks.
class MarkedTexels {
 public:
  explicit MarkedTexels(const TexelRect& rect)
      : rect_(rect), isMarked_(static_cast<std::size_t>(rect.count())) {}

  const TexelRect& rect() const { return rect_; }
  void mark(int i, int j, bool isMarked) { isMarked_[indexOf(i, j)] = isMarked; }
  bool isMarked(int i, int j) const { return isMarked_[indexOf(i, j)]; }
  std::size_t indexOf(int i, int j) const {
    return static_cast<std::size_t>(j - rect_.j0) * static_cast<std::size_t>(rect_.width) +
           static_cast<std::size_t>(i - rect_.i0);
  }

 private:
  TexelRect rect_;
  std::vector<bool> isMarked_;
};

/// The marked texels of a rectangle, to be found by their distance. As each row knows
/// the nearest ones to either side, a search visits as many rows as that distance, not as many
/// texels as its square.
class NearestMarked {
 public:
  explicit NearestMarked(const MarkedTexels& marked)
      : marked_(marked), left_(static_cast<std::size_t>(marked.rect().count())), right_(left_) {
    const TexelRect& rect = marked.rect();
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j) {
      int nearest = kNone;
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i)
        left_[marked.indexOf(i, j)] = nearest = marked.isMarked(i, j) ? i : nearest;
      nearest = kNone;
      for (int i = rect.i0 + rect.width; i-- > rect.i0;)
        right_[marked.indexOf(i, j)] = nearest = marked.isMarked(i, j) ? i : nearest;
    }
  }

  struct Texel {
    int i;
    int j;
  };

  /// The nearest one to a texel. Of several that with the smaller square around the texel, then the
  /// upper one, then the left one.
  std::optional<Texel> nearestTo(int i, int j) const {
    using Distance = std::tuple<std::int64_t, int, int, int>;
    Distance least{std::numeric_limits<std::int64_t>::max(), 0, 0, 0};
    const TexelRect& rect = marked_.rect();
    for (int rows = 0; rows < rect.height && std::int64_t{rows} * rows <= std::get<0>(least);
         ++rows)
      for (const int dj : {-rows, rows}) {
        if (j + dj < rect.j0 || j + dj >= rect.j0 + rect.height) continue;
        const std::size_t at = marked_.indexOf(i, j + dj);
        for (const int found : {left_[at], right_[at]}) {
          if (found == kNone) continue;
          const int di = found - i;
          least = std::min(least, Distance{std::int64_t{di} * di + std::int64_t{dj} * dj,
                                           std::max(std::abs(di), rows), dj, di});
        }
      }
    const auto [distance, ring, dj, di] = least;
    if (ring == 0) return std::nullopt;
    return Texel{i + di, j + dj};
  }

 private:
  static constexpr int kNone = std::numeric_limits<int>::min();

  const MarkedTexels& marked_;
  // By texel, the column of the nearest in its row to the left and to the right, or its own:
  std::vector<int> left_;
  std::vector<int> right_;
};

}  // namespace

void EmptyTexels::fill(Lightmap& map) const {
  if (texels_.empty()) return;
  const TexelRect& rect = used_.rect();
  MarkedTexels hasSample(rect);
  for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
    used_.forEachRunIn(rect, j, [&](int first, int last) {
      for (int i = first; i <= last; ++i) hasSample.mark(i, j, true);
    });
  for (const auto [i, j] : texels_) hasSample.mark(i, j, false);
  const NearestMarked withSample(hasSample);
  for (const auto [i, j] : texels_)
    if (const auto nearest = withSample.nearestTo(i, j))
      map.copyTexel(nearest->i, nearest->j, i, j);
}

}  // namespace hearth
