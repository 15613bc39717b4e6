#pragma once

#include <optional>

#include "image/image.h"
#include "level/scene.h"
#include "render/shown_columns.h"

namespace hearth {

/// The colour of the outline that parts a pixel from the one to its left or above it: that of
/// walls, openings, or flat portals and borders in stacks. None within a surface, between skies,
/// and beside what shows no surface.
std::optional<Rgb> outlineColor(const Scene& scene, const ShownSurface& pixel,
                                const ShownSurface& left, const ShownSurface& above);

}  // namespace hearth
