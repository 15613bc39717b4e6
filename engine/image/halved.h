#pragma once

#include "image/image.h"

namespace hearth {

/// The picture at half its width and height, rounded down, but no less than a pixel: each of its
/// pixels is the mean of what it covers. Not of an empty picture.
Image halved(const Image& image);

}  // namespace hearth
