#include "math/box_tree.h"

#include <algorithm>

namespace hearth {

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  leaves_.reserve(boxes.size());
  for (const Box& box : boxes) leaves_.push_back({box, static_cast<std::uint32_t>(leaves_.size())});
  if (!boxes.empty()) build(0, static_cast<std::uint32_t>(boxes.size()));
}

void BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t index = nodes_.size();
  Box box = leaves_[begin].box;
  for (std::uint32_t i = begin; i < end; ++i) box = join(box, leaves_[i].box);
  nodes_.push_back({box, begin, end, 0});
  if (end - begin > kLeavesAtOnce) {
    nodes_[index].lastLeaf = begin;
    const bool alongX = box.max.x - box.min.x > box.max.y - box.min.y;
    const auto twiceCentre = [&](const Leaf& leaf) {
      return alongX ? leaf.box.min.x + leaf.box.max.x : leaf.box.min.y + leaf.box.max.y;
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(leaves_.begin() + begin, leaves_.begin() + middle, leaves_.begin() + end,
                     [&](const Leaf& a, const Leaf& b) { return twiceCentre(a) < twiceCentre(b); });
    build(begin, middle);
    build(middle, end);
  }
  nodes_[index].afterAll = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace hearth
