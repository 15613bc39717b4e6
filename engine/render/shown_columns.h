#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "level/ids.h"
#include "level/mesh.h"
#include "math/vec.h"

/// What pixels show, as far as marks need it.
namespace hearth {

/// The lines of a texel grid at or before a place, by their numbers.
struct GridLines {
  std::int64_t s = 0;
  std::int64_t t = 0;

  friend bool operator==(const GridLines&, const GridLines&) = default;
};

struct ShownTexel {
  std::optional<SurfaceId> surface = {};  ///< the last that was drawn there, if it has texels
  Vec2 texel = {};                        ///< on the surface's texel grid
  GridLines lines = {};
};

struct ShownSurface {
  std::optional<SurfaceId> surface = {};  ///< the last that was drawn there, if any
  double depth = 0;                       ///< metres; infinite for sky
};

struct ShownTimes {
  int times = 0;  ///< how often something was drawn there
};

struct ShownFace {
  const MeshFace* face = nullptr;  ///< of what was drawn there last, if it is of a mesh
};

/// What the pixels of a column show, row by row, and those of the column to its left. Columns come
/// from left to right; two of them stay in the processor's caches.
template <typename Shown>
class ShownColumns {
 public:
  /// At first nothing shows, neither here nor to the left.
  explicit ShownColumns(int height)
      : left_(static_cast<std::size_t>(height)), here_(static_cast<std::size_t>(height)) {}

  /// Goes on to the next column, where nothing shows yet.
  void next() {
    std::swap(left_, here_);
    std::ranges::fill(here_, Shown{});
  }

  const std::vector<Shown>& left() const { return left_; }
  const std::vector<Shown>& here() const { return here_; }
  std::vector<Shown>& here() { return here_; }

 private:
  std::vector<Shown> left_;
  std::vector<Shown> here_;
};

}  // namespace hearth
