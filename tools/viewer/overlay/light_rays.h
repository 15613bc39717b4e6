#pragma once

#include <cstddef>
#include <optional>

#include "image/image.h"
#include "level/light_source.h"
#include "render/camera.h"
#include "viewer/inspect/inspect.h"

namespace hearth {

/// The colour in which a light, its ray and its mark are shown.
Rgb colorOf(const LightSource& light);

/// Draws the ways of the listed lights to the place into the picture, beneath the panel: in a
/// light's colour as far as it comes, red and dashed from there on, with a cross where it is
/// stopped. What walls hide from the eye is dim. Of one light alone if the pointer is on it.
void drawLightRays(const Inspection& found, std::optional<std::size_t> pointed, const Scene& scene,
                   const Camera& camera);

}  // namespace hearth
