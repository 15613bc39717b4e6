#include "load/validate/hole_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

/// Looks from the rightmost vertex of a hole to the right, at the first wall there. Nothing lies
/// between, so if the wall faces the hole, and its own loop lies where it should, so does the hole.
/// That loop reaches farther to the right: from hole to hole the way ends at the border.
class HolePlaces {
 public:
  HolePlaces(const Outlines& outlines, const OutlineSector& sector, const BoxTree& tree)
      : outlines_(outlines), sector_(sector), tree_(tree), isPlaced_(sector.loops.size()) {
    isPlaced_[0] = true;
    for (const OutlineLoop& loop : sector.loops) rightmost_.push_back(rightmostOf(loop));
  }

  /// Holes, in an order in which those that others see come first.
  std::vector<std::uint32_t> fromTheRight() const {
    std::vector<std::uint32_t> holes(sector_.loops.size() - 1);
    std::iota(holes.begin(), holes.end(), 1U);
    std::ranges::stable_sort(holes, std::greater(),
                             [&](std::uint32_t hole) { return rightmost_[hole].x; });
    return holes;
  }

  bool isPlain(std::uint32_t hole) const {
    const std::optional<std::uint32_t> wall = firstFrom(rightmost_[hole], hole);
    if (!wall) return false;
    const Edge& edge = outlines_.edges[*wall];
    return isPlaced_[edge.loop] &&
           orientation(outlines_.from(edge), outlines_.to(edge), rightmost_[hole]) > 0;
  }
  void setPlaced(std::uint32_t hole, bool isPlaced) { isPlaced_[hole] = isPlaced; }

 private:
  Vec2 rightmostOf(const OutlineLoop& loop) const {
    const std::span<const Vec2> vertices(&outlines_.points[loop.firstVertex], loop.edgeCount);
    return *std::ranges::max_element(vertices, {}, &Vec2::x);
  }

  /// The first wall of another loop that a ray towards +x meets; none where that is not clear.
  std::optional<std::uint32_t> firstFrom(Vec2 p, std::uint32_t hole) const {
    double reach = outlines_.length(outlines_.edges[sector_.loops[hole].firstEdge]);
    while (true) {
      const double end = p.x + reach;
      const auto [wall, x, nextX] = firstUpTo(end, p, hole);
      if (x + kAuthorNoise < end) {
        const bool isClear = x > p.x + kAuthorNoise && nextX > x + kAuthorNoise;
        return isClear ? std::optional(wall) : std::nullopt;
      }
      if (end > rightmost_[0].x) return std::nullopt;
      reach *= 4;
    }
  }

  struct FirstWall {
    std::uint32_t wall = 0;
    double x = kBeyondAll;
    double nextX = kBeyondAll;  ///< of the second
  };
  FirstWall firstUpTo(double end, Vec2 p, std::uint32_t hole) const {
    FirstWall first;
    tree_.query({p, {end, p.y}}, [&](std::uint32_t i) {
      const Edge& edge = outlines_.edges[sector_.firstEdge + i];
      const std::optional<double> x = crossingOf(edge, p);
      if (edge.loop == hole || !x) return;
      if (*x < first.x)
        first = {sector_.firstEdge + i, *x, first.x};
      else
        first.nextX = std::min(first.nextX, *x);
    });
    return first;
  }

  /// Where the ray from p towards +x meets a wall.
  std::optional<double> crossingOf(const Edge& edge, Vec2 p) const {
    const Vec2 a = outlines_.from(edge);
    const Vec2 b = outlines_.to(edge);
    if ((a.y <= p.y) == (b.y <= p.y) || (orientation(a, b, p) > 0) != (b.y > p.y))
      return std::nullopt;
    return std::lerp(a.x, b.x, (p.y - a.y) / (b.y - a.y));
  }

  const Outlines& outlines_;
  const OutlineSector& sector_;
  const BoxTree& tree_;
  std::vector<Vec2> rightmost_;  ///< vertices, by loop
  std::vector<bool> isPlaced_;   ///< by loop
};

}  // namespace

void checkHolePlaces(const Outlines& outlines, const OutlineSector& sector, const BoxTree& tree,
                     const std::function<bool(std::uint32_t)>& touches,
                     const std::function<bool(std::uint32_t)>& check) {
  HolePlaces places(outlines, sector, tree);
  for (const std::uint32_t hole : places.fromTheRight())
    places.setPlaced(hole, (!touches(hole) && places.isPlain(hole)) || check(hole));
}

}  // namespace hearth
