#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "level/eight_boxes.h"
#include "level/face_ray.h"
#include "level/mesh.h"
#include "math/box3.h"

namespace hearth {

/// A hierarchy of boxes over the faces of a mesh: a BVH, divided by the surface area heuristic
/// (Pharr, Jakob and Humphreys, "Physically Based Rendering", 4.3). Each node has up to eight parts
/// (Wald, Benthin and Boulos, "Getting Rid of Packets", 2008).
class FaceTree {
 public:
  explicit FaceTree(std::span<const MeshFace> faces);

  /// Around all faces.
  const Box3& box() const { return box_; }

  /// Makes it that of the faces of `original`, all of them raised by so many metres. As large as
  /// it, which must be of the same faces.
  void raiseFrom(const FaceTree& original, double rise);

  // `faces` are those that the tree was made of. Rays meet faces from the ray parameter `tFrom` to
  // `tTo`, both included, and beyond their origin.

  /// Whether the ray meets any.
  bool stops(std::span<const MeshFace> faces, const FaceRay& ray, double tFrom, double tTo) const;
  /// The first that the ray meets. A back counts as if it were `tie` nearer, as ray parameter: it
  /// comes before a front that it touches.
  std::optional<FaceRay::Crossing> nearest(std::span<const MeshFace> faces, const FaceRay& ray,
                                           double tFrom, double tTo, double tie) const;

  /// Whether `test(face)`, of an index into the mesh's faces, holds for one of those in boxes all
  /// around which `mayMeet(box)` holds. No more is tested once one does. Boxes are a rounding of
  /// single precision larger than what is in them.
  template <typename MayMeet, typename Test>
  bool anyFace(MayMeet&& mayMeet, Test&& test) const {
    return anyLeaf([&](const Node& node) { return metBy(mayMeet, node); },
                   [](const Node&) { return false; }, test);
  }
  /// The same, of the boxes that a ray meets. `test` may move the ray's end.
  template <typename Test>
  bool anyFaceOn(const BoxRay& ray, Test&& test) const {
    return anyLeaf([&](const Node& node) { return ray.met(node.boxes); },
                   [&](const Node& node) { return ray.runsDown(node.axis); }, test);
  }
  BoxRay boxRay(const FaceRay& ray, double tFrom, double tTo) const {
    return {ray, middle_, tFrom, tTo};
  }

  std::size_t bytes() const {
    return nodes_.size() * sizeof(Node) + faces_.size() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::size_t kMaxDepth = 64;
  /// A leaf, or a node with parts.
  struct Part {
    std::uint32_t first;  ///< of its faces in `faces_`, or the node in `nodes_`
    std::uint32_t count;  ///< of faces; 0 of a node
  };
  struct Node {
    EightBoxes boxes;
    std::array<std::uint32_t, EightBoxes::kCount> first;  ///< of the parts, as in Part
    std::array<std::uint8_t, EightBoxes::kCount> count;
    std::uint8_t parts;
    std::uint8_t axis;  ///< along which the first parts come before the last
  };
  class Builder;

  template <typename Met, typename IsReversed, typename Test>
  bool anyLeaf(Met&& met, IsReversed&& isReversed, Test&& test) const;
  template <typename MayMeet>
  std::uint32_t metBy(MayMeet&& mayMeet, const Node& node) const;

  Box3 box_;
  Vec3 middle_;  ///< to which the boxes of nodes are relative
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> faces_;
};

template <typename Met, typename IsReversed, typename Test>
bool FaceTree::anyLeaf(Met&& met, IsReversed&& isReversed, Test&& test) const {
  std::array<Part, EightBoxes::kCount * kMaxDepth> stack;
  std::size_t left = 0;
  stack[left++] = {0, 0};
  while (left > 0) {
    const Part part = stack[--left];
    if (part.count == 0) {
      const Node& node = nodes_[part.first];
      const bool reversed = isReversed(node);
      // The last one of the stack is the next.
      for (std::uint32_t bits = met(node) & ((1U << node.parts) - 1); bits != 0;) {
        const auto i =
            static_cast<std::size_t>(reversed ? std::countr_zero(bits) : std::bit_width(bits) - 1);
        bits ^= 1U << i;
        stack[left++] = {node.first[i], node.count[i]};
      }
    }
    for (std::uint32_t i = 0; i < part.count; ++i)
      if (test(faces_[part.first + i])) return true;
  }
  return false;
}

template <typename MayMeet>
std::uint32_t FaceTree::metBy(MayMeet&& mayMeet, const Node& node) const {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < node.parts; ++i) {
    const Box3 box = node.boxes[i];
    if (mayMeet(Box3{middle_ + box.min, middle_ + box.max})) bits |= 1U << i;
  }
  return bits;
}

}  // namespace hearth
