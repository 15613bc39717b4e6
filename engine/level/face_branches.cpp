#include "level/face_branches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hearth {

namespace {

constexpr std::size_t kMaxBins = 16;
/// Below, faces are halved by number: so branches are no deeper than this and the 31 that number
/// 2^31 faces.
constexpr std::size_t kMaxDepthByArea = 32;
static_assert(kMaxDepthByArea + 31 < FaceBranches::kMaxDepth);

Box3 boxOf(const MeshFace& face) {
  Box3 box;
  for (const Vec3 corner : face.corners) box.add(corner);
  return box;
}

double farthestCoordinate(const Box3& box) {
  double farthest = 0;
  for (const Vec3 p : {box.min, box.max})
    for (const double coordinate : {p.x, p.y, p.z})
      farthest = std::max(farthest, std::abs(coordinate));
  return farthest;
}

/// Some boxes of faces.
struct FaceBin {
  FloatBox box;
  std::uint32_t count = 0;

  void add(const FaceBin& other) {
    box.add(other.box);
    count += other.count;
  }
  /// Of asking all of its faces, times the area around all faces that are divided.
  float cost() const { return static_cast<float>(count) * box.halfArea(); }
};

class FaceDivider {
 public:
  explicit FaceDivider(std::span<const MeshFace> faces) {
    Box3& box = divided_.box;
    for (const MeshFace& face : faces) box.add(boxOf(face));
    divided_.middle = 0.5 * (box.min + box.max);
    items_.reserve(faces.size());
    for (const MeshFace& face : faces)
      items_.push_back({relative(boxOf(face)), static_cast<std::uint32_t>(items_.size())});
  }

  FaceBranches divideAll() {
    const auto count = static_cast<std::uint32_t>(items_.size());
    divided_.branches.push_back({relative(divided_.box), 0, count, 0});
    divide(0, 0);
    for (const Item& item : items_) divided_.faces.push_back(item.face);
    return std::move(divided_);
  }

 private:
  /// Boxes lie side by side with what is moved with them, so that memory is read in one direction.
  struct Item {
    FloatBox box;
    std::uint32_t face;

    FloatBox twiceMiddle() const {
      FloatBox::Corner sum;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = box.min[i] + box.max[i];
      return {sum, sum};
    }
    float twiceMiddle(std::size_t axis) const { return box.min[axis] + box.max[axis]; }
  };

  /// Divides a stretch of an axis into bins of one width.
  struct Bins {
    std::size_t axis;
    float low;  ///< twice the middles of boxes
    float perWidth;
    float last;  ///< bin

    std::size_t of(const Item& item) const {
      // In the last one, too, what is no number.
      return static_cast<std::size_t>(std::min(last, (item.twiceMiddle(axis) - low) * perWidth));
    }
  };

  struct Split {
    Bins bins;
    std::size_t bin;  ///< the first of the upper part
    float cost;
    FaceBin lower;
    FaceBin upper;
  };

  void divide(std::size_t index, std::size_t depth) {
    const FaceBranch branch = divided_.branches[index];
    if (branch.count <= FaceBranches::kMaxFacesOfLeaf) return;
    const std::span items = std::span(items_).subspan(branch.first, branch.count);
    const auto split = depth < kMaxDepthByArea ? cheapestSplit(items) : std::nullopt;
    // Otherwise they all have one middle, or are deep.
    const auto [lower, upper] = split ? parted(items, *split) : halved(items);
    const auto part = static_cast<std::uint32_t>(divided_.branches.size());
    divided_.branches.push_back({lower.box, branch.first, lower.count, 0});
    divided_.branches.push_back({upper.box, branch.first + lower.count, upper.count, 0});
    divided_.branches[index] = {branch.box, part, 0,
                                static_cast<std::uint8_t>(split ? split->bins.axis : 0)};
    divide(part, depth + 1);
    divide(part + 1, depth + 1);
  }

  using Parts = std::pair<FaceBin, FaceBin>;

  /// The faces of the lower part come first.
  static Parts parted(std::span<Item> items, const Split& split) {
    std::partition(items.begin(), items.end(),
                   [&](const Item& item) { return split.bins.of(item) < split.bin; });
    return {split.lower, split.upper};
  }

  static Parts halved(std::span<const Item> items) {
    Parts parts;
    for (std::size_t i = 0; i < items.size(); ++i)
      (i < items.size() / 2 ? parts.first : parts.second).add({items[i].box, 1});
    return parts;
  }

  /// None where all have one middle.
  static std::optional<Split> cheapestSplit(std::span<const Item> items) {
    FloatBox middles;
    for (const Item& item : items) middles.add(item.twiceMiddle());
    std::optional<Split> best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto split = cheapestAlong(axis, middles, items);
      if (split && (!best || split->cost < best->cost)) best = split;
    }
    return best;
  }

  static std::optional<Split> cheapestAlong(std::size_t axis, const FloatBox& middles,
                                            std::span<const Item> items) {
    const std::size_t count = std::min(kMaxBins, items.size());
    const float low = middles.min[axis];
    const float perWidth = static_cast<float>(count) / (middles.max[axis] - low);
    if (!std::isnormal(perWidth)) return std::nullopt;
    const Bins division{axis, low, perWidth, static_cast<float>(count - 1)};
    std::array<FaceBin, kMaxBins> bins;
    for (const Item& item : items) bins[division.of(item)].add({item.box, 1});

    std::array<FaceBin, kMaxBins> upper;  // from each bin on
    upper[count - 1] = bins[count - 1];
    for (std::size_t bin = count - 1; bin-- > 1;) {
      upper[bin] = upper[bin + 1];
      upper[bin].add(bins[bin]);
    }
    std::optional<Split> best;
    FaceBin lower;
    for (std::size_t bin = 1; bin < count; ++bin) {
      lower.add(bins[bin - 1]);
      if (lower.count == 0 || upper[bin].count == 0) continue;
      const float cost = lower.cost() + upper[bin].cost();
      if (!best || cost < best->cost) best = {division, bin, cost, lower, upper[bin]};
    }
    return best;
  }

  /// So large that it holds the faces also where it is moved back.
  FloatBox relative(const Box3& box) const {
    const double slack = 0x1p-51 * farthestCoordinate(divided_.box);
    const Vec3 around{slack, slack, slack};
    return FloatBox::around(
        {box.min - divided_.middle - around, box.max - divided_.middle + around});
  }

  std::vector<Item> items_;
  FaceBranches divided_;
};

}  // namespace

FaceBranches divideFaces(std::span<const MeshFace> faces) { return FaceDivider(faces).divideAll(); }

}  // namespace hearth
