#pragma once

#include <optional>
#include <string>

#include "level/level.h"

namespace hearth {

/// Why the level cannot be lit with texels of so many metres, or nothing. Grids and lightmaps may
/// be made only after it was asked.
std::optional<std::string> mistakeInTexel(const Level& level, double texel);

}  // namespace hearth
