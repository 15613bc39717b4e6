#pragma once

#include <optional>

#include "image/image.h"
#include "level/level.h"
#include "render/shown_strip.h"

namespace hearth {

/// The colour of the outline that parts a pixel from the one to its left or above it, which are
/// null at the picture's edge: that of walls, openings, or flat portals and borders in stacks. None
/// within a surface, and between skies.
std::optional<Rgb> outlineColor(const Level& level, const ShownPixel& pixel, const ShownPixel* left,
                                const ShownPixel* above);

}  // namespace hearth
