#pragma once

#include <cstddef>
#include <cstdint>

namespace hearth {

/// How much input is taken before it is refused; checked before memory is taken for it. The
/// command-line option beside each raises it, and messages name that option.
struct LoadLimits {
  std::uint64_t fileBytes = std::uint64_t{64} << 20;  ///< --max-file-bytes; at most 2^32 - 2
  std::int64_t imagePixels = std::int64_t{1} << 26;   ///< --max-image-pixels, per image
  std::size_t vertices = 1'000'000;                   ///< --max-vertices, in all loops together
  std::size_t gridCells = 4'000'000;                  ///< --max-grid-cells
  std::size_t lights = 100'000;                       ///< --max-lights
  std::size_t spriteImages = 250'000;  ///< --max-sprite-images, in all things together
  std::size_t meshFaces = 4'000'000;   ///< --max-mesh-faces, in all models of a level together
};

}  // namespace hearth
