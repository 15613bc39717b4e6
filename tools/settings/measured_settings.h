#pragma once

#include <span>
#include <string_view>

#include "settings/options.h"

namespace hearth {

/// A measurement of `hearth tradeoff` of one setting, with all others at their defaults, on the
/// levels that come with Hearth.
struct MeasuredSetting {
  Option setting;
  std::string_view value;
  double cost;  ///< time of a bake or of a frame, as a fraction of one by the defaults
  /// For settings of bakes the error of light, RMS in levels of 255; for settings of frames the
  /// fraction of pixels that are off by more than 2 levels.
  double off;
};

/// The default and the tried values of each setting.
std::span<const MeasuredSetting> measuredSettings();

/// Null if the value was not measured.
const MeasuredSetting* measuredAlone(Option setting, std::string_view value);

}  // namespace hearth
