#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "level/scene.h"
#include "load/limits.h"
#include "render/draw_settings.h"
#include "settings/options.h"

/// How much to load, and how accurately to bake and to draw: from options to settings, and back.
namespace hearth {

/// The settings of a bake: the command line overrides the file. Errors name the option to change.
tl::expected<BakeSettings, std::string> bakeSettingsFor(const Scene& scene,
                                                        const OptionValues& values);

/// The same without looking for mistakes.
BakeSettings bakeSettingsFrom(const Scene& scene, const OptionValues& values);

/// The options that ask for these settings, whatever the file says.
std::string optionsOf(const BakeSettings& settings);
/// The value with which an option, one of a bake that has a value, asks for them.
std::string valueOf(const BakeSettings& settings, Option option);

/// How many samples a texel has.
std::string samplesInWords(const BakeSettings& settings);

/// What the command line says of how much input is taken.
LoadLimits limitsFrom(const OptionValues& values);

/// How accurately to draw.
DrawSettings drawSettingsFrom(const OptionValues& values);
/// The options that ask for these settings; empty for those that hold without any.
std::string optionsOf(const DrawSettings& settings);
/// The value with which an option of frames asks for them.
std::string valueOf(const DrawSettings& settings, Option option);
/// Those whose values are not what holds without them.
std::vector<Option> notStandard(const DrawSettings& settings);

}  // namespace hearth
