#pragma once

#include <array>

#include "image/image.h"
#include "textures/textures.h"

namespace hearth::textures {

/// Five colours from shade to highlight.
using Ramp = std::array<Rgb, 5>;

/// The colour of a tone in 0..255 (clamped) on the ramp. Tones are cut to 13 steps, dithered in a
/// 4x4 pattern between them: few colours in clean patches, as a painter of pixels would choose.
Rgb shade(const Ramp& ramp, int tone, int x, int y);

/// `a` at weight 0, `b` at weight 256.
Rgb blend(Rgb a, Rgb b, int weight256);

/// Where a pixel lies in the block (brick, stone, plank) that holds it. Coordinates count pixels
/// from the block's upper left corner; the joints around it belong to no block.
struct BlockPixel {
  int x;
  int y;
  int width;
  int height;
};

/// How far the pixel is from the block's nearest edge, in pixels; negative in the joint.
int edgeDistance(BlockPixel pixel);

/// Tone to add for a bevelled edge lit from the upper left.
int bevel(BlockPixel pixel, int strength);

/// A surface texture, kTileSide pixels wide, painted pixel by pixel.
Image paintTile(Rgb (*pixelAt)(int x, int y), int height = kTileSide);

/// Whether the pixel is cut off by the block's rounded corners.
bool inCorner(BlockPixel pixel);

}  // namespace hearth::textures
