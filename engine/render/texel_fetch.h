#pragma once

#include "render/pixel_block.h"
#include "render/pixel_kernels.h"

namespace hearth {

/// Reads the colours of a block's texels, one by one. Compiled for no instruction set in
/// particular, and not into vectors: instructions that gather, and numbers that are taken out of
/// vectors, take longer.
void fetchColors(PixelBlock& block, const GroupTexels& texels);

/// Reads the colours of some rows of one lane, and clears their hole bit. `colors` is the lane's
/// first pixel, of rows of eight.
void fetchColumn(const Texture& image, const std::uint32_t* numbers, int rows,
                 std::uint32_t* colors);

}  // namespace hearth
