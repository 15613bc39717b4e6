#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace hearth::textures {

/// The side of a surface texture in pixels. Each repeats seamlessly in both directions.
inline constexpr int kTileSide = 128;

Image makeBrick();    ///< Running bond, 4 bricks by 8 courses.
Image makePlaster();  ///< Lime plaster with trowel marks and hairline cracks.
Image makeRoof();     ///< Beaver-tail tiles, 8 by 8, the lower edge of each at the bottom.
Image makeStone();    ///< A floor of cut stones of many sizes.
Image makeWood();     ///< Eight planks, their grain along the rows.

/// A dusk panorama of 512x128 pixels, seamless from left to right: the zenith's colour in the top
/// row, haze in the bottom row, both plain, because a sky repeats them beyond the image.
Image makeSky();

struct Texture {
  std::string name;  ///< The file's name without extension.
  Image image;
};

/// All of the above, made with integers only: the same on every machine.
std::vector<Texture> makeAll();

}  // namespace hearth::textures
