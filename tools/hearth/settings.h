#pragma once

#include <string>
#include <tl/expected.hpp>

#include "hearth/options.h"
#include "level/level.h"
#include "render/draw_settings.h"

/// How accurately to bake and to draw: from options to settings, and back.
namespace hearth {

/// The settings of a bake: the command line overrides the file. Errors name the option to change.
tl::expected<BakeSettings, std::string> bakeSettingsFor(const Level& level,
                                                        const OptionValues& values);

/// The options that ask for these settings, whatever the file says.
std::string optionsOf(const BakeSettings& settings);

/// How many samples a texel has.
std::string samplesInWords(const BakeSettings& settings);

/// How accurately to draw.
DrawSettings drawSettingsFrom(const OptionValues& values);
/// The options that ask for these settings; empty for those that hold without any.
std::string optionsOf(const DrawSettings& settings);

}  // namespace hearth
