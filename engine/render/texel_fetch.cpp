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

void fetchColumn(const Texture& image, const std::uint32_t* numbers, int rows,
                 std::uint32_t* colors) {
  const std::uint32_t* const from = image.texels();
  constexpr std::size_t kLanes = PixelBlock::kLanes;
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
    colors[row * kLanes] = from[numbers[row]] & ~kHoleBit;
}

}  // namespace hearth
