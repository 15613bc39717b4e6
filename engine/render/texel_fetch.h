#pragma once

#include "render/pixel_block.h"
#include "render/pixel_kernels.h"

namespace hearth {

/// Reads the colours of a block's texels, one by one. Compiled for no instruction set in
/// particular, and not into vectors: instructions that gather, and numbers that are taken out of
/// vectors, take longer.
void fetchColors(PixelBlock& block, const GroupTexels& texels);

}  // namespace hearth
