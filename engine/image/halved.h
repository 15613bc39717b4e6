#pragma once

#include "image/image.h"

namespace hearth {

/// The picture at half its width and height, rounded down, at least one pixel. Each of its pixels
/// is the mean of the pixels that it covers, weighted by area; none is a hole. The picture must not
/// be empty.
Image halved(const Image& image);

}  // namespace hearth
