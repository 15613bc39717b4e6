#pragma once

#include <optional>
#include <string>

#include "level/scene.h"

namespace hearth {

/// Why the level cannot be lit with texels of so many metres, or nothing. Grids and lightmaps may
/// be made only after it was asked.
std::optional<std::string> mistakeInTexel(const Scene& scene, double texel);

}  // namespace hearth
