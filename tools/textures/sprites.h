#pragma once

#include <vector>

#include "textures/textures.h"

namespace hearth::textures {

/// Frames of the animations below; after the last one comes the first again.
inline constexpr int kFlameFrames = 6;
inline constexpr int kCandleFlameFrames = 4;

Image makeFlame(int frame);        ///< Of a torch or a brazier, 64x96 pixels, 1 m high.
Image makeCandleFlame(int frame);  ///< 24x48 pixels, 12 cm high.
Image makeChain();     ///< 16x512 pixels: 4 m, to be hung so that a ceiling cuts it off.
Image makeGonfalon();  ///< A swallow-tailed cloth on its rod, 64x128 pixels.
Image makeStraw();     ///< Stalks strewn on a floor, seen from above, 128x128 pixels.

/// The images of sprites: pictures with holes, which do not repeat. "flame-1" is the first frame.
/// Made like those of makeAll.
std::vector<Texture> makeSprites();

}  // namespace hearth::textures
