#pragma once

#include <string_view>

#include "render/draw_settings.h"

namespace hearth {

/// A section of the overlay: what the picture shows. `channel` is the name of one, or empty.
void showView(LightMode& mode, std::string_view& channel);

}  // namespace hearth
