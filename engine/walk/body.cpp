#include "walk/body.h"

#include <algorithm>

namespace hearth {

namespace {

constexpr double kCrouchedShare = 0.5;  // of the height

}  // namespace

Body bodyOf(const Level& level, double crouch) {
  const Player player = level.player.value_or(Player{});
  const double share = 1 - (1 - kCrouchedShare) * crouch;
  const double height = std::max(0.0, player.height) * share;
  return {std::max(0.0, player.radius), height, std::clamp(player.eyeHeight * share, 0.0, height),
          std::max(0.0, player.step)};
}

}  // namespace hearth
