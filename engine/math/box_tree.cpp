#include "math/box_tree.h"

#include <algorithm>
#include <numeric>

namespace hearth {

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Box box = boxes_[order_[begin]];
  for (std::uint32_t i = begin; i < end; ++i) box = join(box, boxes_[order_[i]]);
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= kLeafSize) return index;

  const bool alongX = box.max.x - box.min.x > box.max.y - box.min.y;
  const auto twiceCentre = [&](std::uint32_t i) {
    return alongX ? boxes_[i].min.x + boxes_[i].max.x : boxes_[i].min.y + boxes_[i].max.y;
  };
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
      [&](std::uint32_t a, std::uint32_t b) { return twiceCentre(a) < twiceCentre(b); });
  build(begin, middle);
  nodes_[index].right = build(middle, end);
  return index;
}

}  // namespace hearth
