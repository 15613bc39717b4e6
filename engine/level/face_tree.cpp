#include "level/face_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "math/check.h"

namespace hearth {

namespace {

constexpr std::uint32_t kMaxFacesOfLeaf = 4;
constexpr std::size_t kBins = 16;
/// Below, faces are halved by number: so a tree is no deeper than this and the 31 that number 2^31
/// faces.
constexpr std::size_t kMaxDepthByArea = 32;
/// Of what is asked of a box, in tests of a face.
constexpr double kCostOfBox = 1;

Box3 boxOf(const MeshFace& face) {
  Box3 box;
  for (const Vec3 corner : face.corners) box.add(corner);
  return box;
}

/// Half the area of its sides; 0 of an empty box.
double halfArea(const Box3& box) {
  if (box.min.x > box.max.x) return 0;
  const Vec3 size = box.max - box.min;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

Vec3 twiceMiddle(const Box3& box) { return box.min + box.max; }

}  // namespace

class FaceTree::Builder {
 public:
  Builder(std::span<const MeshFace> faces, FaceTree& tree) : tree_(tree) {
    boxes_.reserve(faces.size());
    for (const MeshFace& face : faces) boxes_.push_back(boxOf(face));
    tree_.faces_.resize(faces.size());
    std::iota(tree_.faces_.begin(), tree_.faces_.end(), 0U);
  }

  void build() {
    tree_.nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes_.size())});
    divide(0, 0);
  }

 private:
  struct Split {
    double Vec3::*axis;
    double at;    ///< twice the middles of boxes
    double cost;  ///< in tests of a face
  };

  void divide(std::size_t index, std::size_t depth) {
    const Node node = tree_.nodes_[index];
    Box3 box;
    for (const std::uint32_t face : facesOf(node)) box.add(boxes_[face]);
    tree_.nodes_[index].box = box;
    if (node.count <= 1) return;
    const std::optional<std::uint32_t> lower = lowerPart(node, box, depth);
    if (!lower) return;
    const auto part = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.push_back({{}, node.first, *lower});
    tree_.nodes_.push_back({{}, node.first + *lower, node.count - *lower});
    tree_.nodes_[index].first = part;
    tree_.nodes_[index].count = 0;
    divide(part, depth + 1);
    divide(part + 1, depth + 1);
  }

  std::span<std::uint32_t> facesOf(const Node& node) {
    return std::span(tree_.faces_).subspan(node.first, node.count);
  }

  /// Puts those of one part first, and returns their number; none where the node is to be a leaf.
  std::optional<std::uint32_t> lowerPart(const Node& node, const Box3& box, std::size_t depth) {
    const std::span<std::uint32_t> faces = facesOf(node);
    const std::optional<Split> split =
        depth < kMaxDepthByArea ? cheapestSplit(faces, box) : std::nullopt;
    if (node.count <= kMaxFacesOfLeaf && !(split && split->cost < node.count)) return std::nullopt;
    if (split) {
      const auto isLower = [&](std::uint32_t face) {
        return twiceMiddle(boxes_[face]).*split->axis < split->at;
      };
      const auto rest = std::stable_partition(faces.begin(), faces.end(), isLower);
      return static_cast<std::uint32_t>(rest - faces.begin());
    }
    return node.count / 2;  // they all have one middle, or the tree is deep
  }

  /// None where all have one middle.
  std::optional<Split> cheapestSplit(std::span<const std::uint32_t> faces, const Box3& box) const {
    Box3 middles;
    for (const std::uint32_t face : faces) middles.add(twiceMiddle(boxes_[face]));
    std::optional<Split> best;
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const auto split = cheapestAlong(axis, middles, faces, box);
      if (split && (!best || split->cost < best->cost)) best = split;
    }
    return best;
  }

  std::optional<Split> cheapestAlong(double Vec3::*axis, const Box3& middles,
                                     std::span<const std::uint32_t> faces, const Box3& box) const {
    const double low = middles.min.*axis;
    const double width = (middles.max.*axis - low) / kBins;
    if (!(width > 0) || !(low + width > low)) return std::nullopt;
    struct Bin {
      Box3 box;
      std::size_t count = 0;
    };
    const auto boundary = [&](std::size_t bin) { return low + static_cast<double>(bin) * width; };
    std::array<Bin, kBins> bins;
    for (const std::uint32_t face : faces) {
      const double middle = twiceMiddle(boxes_[face]).*axis;
      auto bin = std::min(kBins - 1, static_cast<std::size_t>((middle - low) / width));
      // As the split will see it, whatever the rounding.
      while (bin > 0 && middle < boundary(bin)) --bin;
      while (bin + 1 < kBins && middle >= boundary(bin + 1)) ++bin;
      bins[bin].box.add(boxes_[face]);
      ++bins[bin].count;
    }
    std::array<double, kBins> upperCost{};  // of bins from each on
    Bin upper;
    for (std::size_t bin = kBins; bin-- > 1;) {
      upper.box.add(bins[bin].box);
      upper.count += bins[bin].count;
      upperCost[bin] = upper.count == 0 ? std::numeric_limits<double>::infinity()
                                        : static_cast<double>(upper.count) * halfArea(upper.box);
    }
    std::optional<Split> best;
    Bin lower;
    const double whole = halfArea(box);
    for (std::size_t bin = 1; bin < kBins; ++bin) {
      lower.box.add(bins[bin - 1].box);
      lower.count += bins[bin - 1].count;
      if (lower.count == 0 || lower.count == faces.size()) continue;
      const double parts = static_cast<double>(lower.count) * halfArea(lower.box) + upperCost[bin];
      const double cost = kCostOfBox + (whole > 0 ? parts / whole : 0);
      if (!best || cost < best->cost) best = Split{axis, boundary(bin), cost};
    }
    return best;
  }

  FaceTree& tree_;
  std::vector<Box3> boxes_;
};

FaceTree::FaceTree(std::span<const MeshFace> faces) {
  CHECK(!faces.empty());
  Builder(faces, *this).build();
}

}  // namespace hearth
