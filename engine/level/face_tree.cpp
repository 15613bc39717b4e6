#include "level/face_tree.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "level/face_branches.h"
#include "math/check.h"

namespace hearth {

/// Makes nodes of branches: of one, of its two parts, of one of these and the two parts of the
/// other, and so on.
class FaceTree::Builder {
 public:
  Builder(std::span<const FaceBranch> branches, FaceTree& tree)
      : branches_(branches), tree_(tree) {}

  /// Returns its index.
  std::uint32_t addNode(const FaceBranch& branch) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    Node node{};
    node.axis = branch.axis;
    for (const FaceBranch* part : partsOf(branch)) {
      const std::size_t i = node.parts++;
      node.boxes.set(i, part->box);
      node.first[i] = part->isLeaf() ? part->first : addNode(*part);
      node.count[i] = static_cast<std::uint8_t>(part->count);
    }
    tree_.nodes_[index] = node;
    return index;
  }

 private:
  /// In the order of their faces. The largest are divided first: rays meet them most often.
  std::vector<const FaceBranch*> partsOf(const FaceBranch& branch) const {
    std::vector<const FaceBranch*> parts{&branch};
    const auto sizeOf = [](const FaceBranch* part) {
      return part->isLeaf() ? -1.0F : part->box.halfArea();
    };
    while (parts.size() < EightBoxes::kCount) {
      const auto largest = std::ranges::max_element(parts, {}, sizeOf);
      if ((*largest)->isLeaf()) break;
      const FaceBranch* lower = &branches_[(*largest)->first];
      *largest = lower;
      parts.insert(largest + 1, lower + 1);
    }
    return parts;
  }

  std::span<const FaceBranch> branches_;
  FaceTree& tree_;
};

FaceTree::FaceTree(std::span<const MeshFace> faces) {
  static_assert(kMaxDepth >= FaceBranches::kMaxDepth);
  CHECK(!faces.empty());
  FaceBranches divided = divideFaces(faces);
  box_ = divided.box;
  middle_ = divided.middle;
  Builder(divided.branches, *this).addNode(divided.branches.front());
  nodes_.shrink_to_fit();
  faces_ = std::move(divided.faces);
}

void FaceTree::raiseFrom(const FaceTree& original, double rise) {
  const Vec3 up{0, 0, rise};
  box_ = {original.box_.min + up, original.box_.max + up};
  middle_ = original.middle_ + up;  // to which all nodes are relative
}

bool FaceTree::stops(std::span<const MeshFace> faces, const FaceRay& ray, double tFrom,
                     double tTo) const {
  return anyFaceOn(boxRay(ray, tFrom, tTo),
                   [&](std::uint32_t face) { return ray.meets(faces[face], tFrom, tTo); });
}

std::optional<FaceRay::Crossing> FaceTree::nearest(std::span<const MeshFace> faces,
                                                   const FaceRay& ray, double tFrom, double tTo,
                                                   double tie) const {
  BoxRay boxes = boxRay(ray, tFrom, tTo);
  std::optional<FaceRay::Crossing> found;
  anyFaceOn(boxes, [&](std::uint32_t face) {
    const std::optional<FaceRay::Crossing> crossing = ray.crossingOf(faces[face]);
    if (!crossing || crossing->t < tFrom || crossing->t > tTo || crossing->t <= 0) return false;
    if (found && found->place(tie) <= crossing->place(tie)) return false;
    found = crossing;
    tTo = std::min(tTo, crossing->place(tie) + tie);
    boxes.endAt(tTo);
    return false;
  });
  return found;
}

}  // namespace hearth
