#pragma once

#include <optional>
#include <string_view>

#include "image/image.h"

namespace hearth {

/// A colour from `#rrggbb`.
std::optional<Rgb> parseColor(std::string_view text);

}  // namespace hearth
