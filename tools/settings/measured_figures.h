#pragma once

#include <optional>
#include <string_view>

#include "level/level.h"
#include "render/draw_settings.h"
#include "settings/options.h"

/// What the measurements of `hearth tradeoff` let expect of settings in a level.
namespace hearth {

struct Figure {
  double cost;  ///< time, as a fraction of that with the level's own settings
  double off;   ///< error, as MeasuredSetting has it
};

/// Of one setting with a value in place of the level's own. None unless both were measured; all
/// other settings were at their defaults then.
std::optional<Figure> figureOf(Option setting, std::string_view value, std::string_view authored);

/// Of all settings of a bake together. None if they were not measured in this combination.
std::optional<Figure> figureOf(const BakeSettings& bake, const BakeSettings& authored);

/// Of all settings of frames together. Levels have none of their own: the cost is a fraction of
/// that of exact frames.
std::optional<Figure> figureOf(const DrawSettings& draw);

}  // namespace hearth
