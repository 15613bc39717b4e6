#include "settings/measured_settings.h"

#include <algorithm>
#include <array>

namespace hearth {

namespace {

// As tools/measure_settings.py prints them, but bakes by processor time: the machine was busy.
constexpr std::array kSettings = {
    MeasuredSetting{Option::Texel, "0.125", 1, 5.1},
    MeasuredSetting{Option::Texel, "1", 0.15, 16},
    MeasuredSetting{Option::Texel, "0.5", 0.24, 11},
    MeasuredSetting{Option::Texel, "0.25", 0.41, 7.5},
    MeasuredSetting{Option::Texel, "0.03125", 9.8, 2.4},
    MeasuredSetting{Option::Texel, "0.0625", 2.6, 3.6},
    MeasuredSetting{Option::Samples, "1", 1, 5.1},
    MeasuredSetting{Option::Samples, "4", 3.7, 4.9},
    MeasuredSetting{Option::Samples, "16", 12, 4.8},
    MeasuredSetting{Option::Samples, "64", 46, 4.8},
    MeasuredSetting{Option::Samples, "auto", 3.9, 4.8},
    MeasuredSetting{Option::SoftSamples, "36", 1, 5.1},
    MeasuredSetting{Option::SoftSamples, "0", 0.33, 5.7},
    MeasuredSetting{Option::SoftSamples, "4", 0.63, 5.1},
    MeasuredSetting{Option::SoftSamples, "16", 0.75, 5.1},
    MeasuredSetting{Option::SoftSamples, "64", 1.3, 5.1},
    MeasuredSetting{Option::SoftSamples, "256", 2.7, 5.1},
    MeasuredSetting{Option::CutOff, "0", 1, 5.1},
    MeasuredSetting{Option::CutOff, "1", 1, 5.1},
    MeasuredSetting{Option::CutOff, "4", 0.96, 5.1},
    MeasuredSetting{Option::CutOff, "16", 0.9, 6.2},
    MeasuredSetting{Option::MiddleShadows, "holes", 1, 12},
    MeasuredSetting{Option::MiddleShadows, "solid", 0.39, 45},
    MeasuredSetting{Option::TextureFilter, "nearest", 1, 0.066},
    MeasuredSetting{Option::TextureFilter, "bilinear", 1.5, 0.29},
    MeasuredSetting{Option::TextureFilter, "mipmapped", 1.2, 0.56},
    MeasuredSetting{Option::LightFilter, "bilinear", 1, 0.066},
    MeasuredSetting{Option::LightFilter, "nearest", 1, 0.043},
    MeasuredSetting{Option::PixelSize, "1", 1, 0.066},
    MeasuredSetting{Option::PixelSize, "2", 0.47, 0.61},
    MeasuredSetting{Option::PixelSize, "3", 0.33, 0.6},
    MeasuredSetting{Option::PixelSize, "4", 0.21, 0.7},
};

}  // namespace

std::span<const MeasuredSetting> measuredSettings() { return kSettings; }

const MeasuredSetting* measuredAlone(Option setting, std::string_view value) {
  const auto isIt = [=](const MeasuredSetting& of) {
    return of.setting == setting && of.value == value;
  };
  const auto* const found = std::ranges::find_if(kSettings, isIt);
  return found == kSettings.end() ? nullptr : found;
}

}  // namespace hearth
