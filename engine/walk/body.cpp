#include "walk/body.h"

#include <algorithm>

namespace hearth {

namespace {

constexpr double kCrouchedFraction = 0.5;  // of the height

}  // namespace

Body bodyOf(const Level& level, double crouch) {
  const Player player = level.player.value_or(Player{});
  const double fraction = 1 - (1 - kCrouchedFraction) * crouch;
  const double height = std::max(0.0, player.height) * fraction;
  return {std::max(0.0, player.radius), height,
          std::clamp(player.eyeHeight * fraction, 0.0, height), std::max(0.0, player.stepHeight)};
}

}  // namespace hearth
