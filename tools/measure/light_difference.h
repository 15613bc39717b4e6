#pragma once

#include <cstdint>

#include "light/bakery.h"

namespace hearth {

/// How far two kinds of light on the same texel grids are apart, over the texels that can be seen
/// of level surfaces. Meshes and sprites do not count.
struct LightDifference {
  static constexpr int kVisible = 4;  ///< levels

  std::int64_t texels = 0;   ///< that were compared: those that either lights
  std::int64_t visible = 0;  ///< of those, the ones with a channel more than kVisible levels off
  double rms = 0;            ///< levels, over the channels of these texels
  int most = 0;              ///< levels
};

LightDifference differenceOf(const BakedLight& a, const BakedLight& b);

}  // namespace hearth
