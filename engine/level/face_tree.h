#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/mesh.h"
#include "math/box3.h"

namespace hearth {

/// A hierarchy of boxes over the faces of a mesh: a BVH, divided by the surface area heuristic
/// (Pharr, Jakob and Humphreys, "Physically Based Rendering", 4.3).
class FaceTree {
 public:
  explicit FaceTree(std::span<const MeshFace> faces);

  /// Around all faces, at most a rounding larger.
  const Box3& box() const { return nodes_.front().box; }

  /// Whether `test(face)`, of an index into the mesh's faces, holds for one of those in boxes all
  /// around which `mayMeet(box)` holds. No more is tested once one does.
  template <typename MayMeet, typename Test>
  bool anyFace(MayMeet&& mayMeet, Test&& test) const {
    std::array<std::uint32_t, kMaxDepth + 1> stack;
    std::size_t left = 0;
    stack[left++] = 0;
    while (left > 0) {
      const Node& node = nodes_[stack[--left]];
      if (!mayMeet(node.box)) continue;
      if (node.count == 0) {
        stack[left++] = node.first + 1;
        stack[left++] = node.first;
        continue;
      }
      for (std::uint32_t i = 0; i < node.count; ++i)
        if (test(faces_[node.first + i])) return true;
    }
    return false;
  }

  std::size_t bytes() const {
    return nodes_.size() * sizeof(Node) + faces_.size() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::size_t kMaxDepth = 64;
  struct Node {
    Box3 box;
    std::uint32_t first;  ///< of its faces in `faces_`, or of its two parts in `nodes_`
    std::uint32_t count;  ///< of faces; 0 of what has parts
  };
  class Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> faces_;
};

}  // namespace hearth
