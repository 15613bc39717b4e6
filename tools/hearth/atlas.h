#pragma once

#include "image/image.h"
#include "light/bakery.h"

namespace hearth {

/// All lightmaps of a level side by side, one pixel a texel, the tallest first: a picture to look
/// at. Walls stand upright in it.
Image lightmapAtlas(const BakedLight& light);

}  // namespace hearth
