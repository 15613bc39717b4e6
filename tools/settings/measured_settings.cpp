#include "settings/measured_settings.h"

#include <algorithm>
#include <array>

namespace hearth {

namespace {

// As tools/measure_settings.py prints them, but costs of runs in which the machine was less busy;
// the castle's bakes took two threads there. Those of gather errors are of light that bounces, in
// tests/MEASUREMENTS.md.
constexpr std::array kSettings = {
    MeasuredSetting{Option::Texel, "0.125", 1, 5.6},
    MeasuredSetting{Option::Texel, "1", 0.14, 17},
    MeasuredSetting{Option::Texel, "0.5", 0.22, 12},
    MeasuredSetting{Option::Texel, "0.25", 0.41, 8.2},
    MeasuredSetting{Option::Texel, "0.03125", 9.7, 2.7},
    MeasuredSetting{Option::Texel, "0.0625", 2.9, 4},
    MeasuredSetting{Option::Samples, "1", 1, 5.6},
    MeasuredSetting{Option::Samples, "4", 3.4, 5.4},
    MeasuredSetting{Option::Samples, "16", 12, 5.3},
    MeasuredSetting{Option::Samples, "64", 45, 5.3},
    MeasuredSetting{Option::Samples, "auto", 3.3, 5.4},
    MeasuredSetting{Option::SoftSamples, "36", 1, 5.6},
    MeasuredSetting{Option::SoftSamples, "0", 0.3, 6.2},
    MeasuredSetting{Option::SoftSamples, "4", 0.57, 5.6},
    MeasuredSetting{Option::SoftSamples, "16", 0.75, 5.6},
    MeasuredSetting{Option::SoftSamples, "64", 1.3, 5.6},
    MeasuredSetting{Option::SoftSamples, "256", 3, 5.6},
    MeasuredSetting{Option::CutOff, "0", 1, 5.6},
    MeasuredSetting{Option::CutOff, "1", 0.99, 5.6},
    MeasuredSetting{Option::CutOff, "4", 1, 5.6},
    MeasuredSetting{Option::CutOff, "16", 0.97, 6.6},
    MeasuredSetting{Option::GatherError, "1", 1, 1.9},
    MeasuredSetting{Option::GatherError, "0.25", 3.8, 1.5},
    MeasuredSetting{Option::GatherError, "0.5", 1.9, 1.7},
    MeasuredSetting{Option::GatherError, "2", 0.53, 2.9},
    MeasuredSetting{Option::GatherError, "4", 0.32, 4.2},
    MeasuredSetting{Option::GatherError, "8", 0.24, 4.5},
    MeasuredSetting{Option::MiddleShadows, "holes", 1, 11},
    MeasuredSetting{Option::MiddleShadows, "solid", 0.37, 44},
    MeasuredSetting{Option::MoverStages, "0", 1, 0.94},
    MeasuredSetting{Option::MoverStages, "1", 2.1, 0.61},
    MeasuredSetting{Option::MoverStages, "3", 4.1, 0.41},
    MeasuredSetting{Option::MoverStages, "7", 7.8, 0.28},
    MeasuredSetting{Option::TextureFilter, "nearest", 1, 0.073},
    MeasuredSetting{Option::TextureFilter, "bilinear", 1.7, 0.3},
    MeasuredSetting{Option::TextureFilter, "mipmapped", 1.3, 0.56},
    MeasuredSetting{Option::LightFilter, "bilinear", 1, 0.073},
    MeasuredSetting{Option::LightFilter, "nearest", 1, 0.047},
    MeasuredSetting{Option::PixelSize, "1", 1, 0.073},
    MeasuredSetting{Option::PixelSize, "2", 0.64, 0.62},
    MeasuredSetting{Option::PixelSize, "3", 0.46, 0.6},
    MeasuredSetting{Option::PixelSize, "4", 0.33, 0.7},
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
