#pragma once

#include <algorithm>
#include <limits>

#include "level/level.h"

namespace hearth {

/// A rectangle of the map, in metres. It is empty until a point is added.
struct PlanBox {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high = -1 * low;

  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double longerSide() const { return std::max(high.x - low.x, high.y - low.y); }
  PlanBox common(const PlanBox& other) const {
    return {{std::max(low.x, other.low.x), std::max(low.y, other.low.y)},
            {std::min(high.x, other.high.x), std::min(high.y, other.high.y)}};
  }
  bool meets(const PlanBox& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
           other.low.y < high.y;
  }
  bool contains(Vec2 p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
};

/// The rectangle that a plan of the level has to show: around all sectors, except those that are
/// much larger than the rectangle around the lights, the shots and the player.
PlanBox planFrame(const Level& level);

}  // namespace hearth
