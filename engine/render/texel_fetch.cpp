#include "render/texel_fetch.h"

namespace hearth {

void fetchColors(PixelBlock& block, const GroupTexels& texels) {
  const std::uint32_t* const from = texels.image->texels();
  for (std::size_t i = 0; i < (texels.areMixed ? 4 : 1); ++i)
    for (std::size_t row = 0; row < block.count(); row += PixelBlock::kLanes) {
      const std::uint32_t* const numbers = &block.texels[i][row];
      std::uint32_t* const colors = &block.colors[i][row];
      for (std::size_t k = 0; k < PixelBlock::kLanes; ++k) colors[k] = from[numbers[k]];
    }
  if (texels.areWhite)
    for (std::size_t k = 0; k < block.count(); ++k) block.colors[0][k] |= 0xFFFFFF;
}

}  // namespace hearth
