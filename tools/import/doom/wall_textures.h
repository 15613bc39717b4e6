#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <unordered_map>

#include "image/image_file.h"
#include "import/doom/wad.h"

namespace hearth::doom {

/// The texture of a wall: patches, drawn one over the other.
class WallTexture {
 public:
  struct Placement {
    int left;  ///< pixels from the left border of the texture to that of the patch
    int top;   ///< the same of their upper borders; Doom has a patch that is alone in a column at 0
    int patch;  ///< its number in PNAMES
  };

  WallTexture(ImageSize size, Bytes placements) : size_(size), placements_(placements) {}

  ImageSize size() const { return size_; }
  std::size_t countPlacements() const;
  Placement placement(std::size_t i) const;

 private:
  ImageSize size_;
  Bytes placements_;
};

/// By name; an error sentence if a definition cannot be used.
using WallTextures = std::unordered_map<std::string, tl::expected<WallTexture, std::string>>;

/// The definitions in TEXTURE1 and TEXTURE2 (https://doomwiki.org/wiki/TEXTURE1_and_TEXTURE2), of
/// which there may be either, both or none. As in Doom, the first one of a name counts. A lump is
///
///     int32 how many; of each, where it begins, counted from the start of the lump
///
/// and a definition
///
///     8 bytes name, int32 unused, int16 width, height, int32 unused, int16 how many patches;
///     of each, int16 left, top, number, and two that are unused
tl::expected<WallTextures, std::string> readWallTextures(const Wad& wad);

}  // namespace hearth::doom
