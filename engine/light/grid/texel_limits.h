#pragma once

#include <optional>
#include <string>

#include "level/scene.h"

namespace hearth {

/// Why the level cannot be lit with texels of so many metres; none if it can. Call it
/// before grids and lightmaps are made.
std::optional<std::string> mistakeInTexel(const Scene& scene, double texel);

}  // namespace hearth
