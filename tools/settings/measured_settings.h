#pragma once

#include <span>
#include <string_view>

#include "settings/options.h"

namespace hearth {

/// What `hearth tradeoff` measured of a setting by itself, all others as they are by default, on
/// the levels that come with Hearth.
struct MeasuredSetting {
  Option setting;
  std::string_view value;
  double cost;  ///< time of a bake or of a frame, as a fraction of one by the defaults
  /// Of what bakes the error of light, RMS in levels of 255; of what draws the fraction of pixels
  /// that are off by more than 2 levels.
  double off;
};

/// Of each setting its default, and what is tried.
std::span<const MeasuredSetting> measuredSettings();

/// Null where the value was not measured.
const MeasuredSetting* measuredAlone(Option setting, std::string_view value);

}  // namespace hearth
