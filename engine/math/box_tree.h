#pragma once

#include <cstdint>
#include <vector>

#include "math/box.h"

namespace hearth {

/// Finds boxes near a place without looking at all of them: a binary tree, each level of which
/// halves its boxes along the longer side of their common box. Built in O(n log n).
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Calls `visit(index)` for every box that touches `range`, in no particular order.
  template <typename Visit>
  void query(Box range, Visit&& visit) const {
    if (!nodes_.empty()) query(0, range, visit);
  }

 private:
  static constexpr std::uint32_t kLeafSize = 4;

  struct Node {
    Box box;
    std::uint32_t begin;  ///< of its part of order_
    std::uint32_t end;
    std::uint32_t right;  ///< node; 0 for a leaf. The left one follows its parent.
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  template <typename Visit>
  void query(std::uint32_t index, Box range, Visit& visit) const {
    const Node& node = nodes_[index];
    if (!touch(node.box, range)) return;
    if (node.right != 0) {
      query(index + 1, range, visit);
      query(node.right, range, visit);
      return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (touch(boxes_[order_[i]], range)) visit(order_[i]);
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace hearth
