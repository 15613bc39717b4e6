#pragma once

#include "image/image.h"

namespace hearth {

/// The picture at half its width and height, rounded down, at least one pixel. Each of its pixels
/// is the mean of those that it covers. The picture must not be empty.
Image halved(const Image& image);

}  // namespace hearth
