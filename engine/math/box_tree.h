#pragma once

#include <cstdint>
#include <vector>

#include "math/box.h"

namespace hearth {

/// Finds boxes near a place without looking at all of them: a binary tree, each level of which
/// halves its boxes along the longer side of their common box. Built in O(n log n).
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls `visit(index)` for every box that touches `range`, in no particular order.
  template <typename Visit>
  void query(const Box& range, Visit&& visit) const {
    for (std::size_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      if (!touch(node.box, range)) {
        i = node.afterAll;
        continue;
      }
      for (std::uint32_t leaf = node.firstLeaf; leaf < node.lastLeaf; ++leaf)
        if (touch(leaves_[leaf].box, range)) visit(leaves_[leaf].index);
      ++i;
    }
  }

 private:
  static constexpr std::uint32_t kLeavesAtOnce = 8;

  struct Leaf {
    Box box;
    std::uint32_t index;
  };

  /// Its first child follows it, and its second one all that is below the first.
  struct Node {
    Box box;
    std::uint32_t firstLeaf;  ///< its leaves, if it has no children
    std::uint32_t lastLeaf;
    std::uint32_t afterAll;  ///< the node after all that are below it
  };

  void build(std::uint32_t begin, std::uint32_t end);

  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
};

}  // namespace hearth
