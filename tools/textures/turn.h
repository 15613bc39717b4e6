#pragma once

#include "image/image.h"

namespace hearth::textures {

/// A square image turned by a quarter, clockwise: what was at its bottom is on its left.
Image turned(const Image& tile);

/// A tile for a slope that falls to the lower right by about 60 degrees. Seen from above, such a
/// slope is half as long as it is; so the tile is packed twice as densely down the slope as across.
/// Drawn at sqrt(2) times the tile's scale, its parts are as large as the tile's. It repeats as the
/// tile does.
Image diagonal(const Image& tile);

}  // namespace hearth::textures
