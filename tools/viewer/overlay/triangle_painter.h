#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/pixel_rows.h"

struct ImDrawData;

namespace hearth {

/// The texture of all triangles: letters, and a white spot for plain areas. Texels say how much of
/// its vertices' colour a triangle has there, 0..255, row by row.
struct GlyphAtlas {
  int width = 0;  ///< texels, at most TrianglePainter::kMaxTexels, as is the height
  int height = 0;
  std::span<const std::uint8_t> cover = {};  ///< width * height of them
};

/// Draws the triangles of Dear ImGui into a picture, in whole numbers alone:
///
/// - Corners are rounded to 1/16 of a pixel, their places on the atlas to 1/256 of a texel.
/// - A triangle covers the pixels whose centres it contains; centres on its edge are its own if
///   that edge is at its top or left. So triangles with a common edge cover each pixel once.
/// - Of these, the pixels are drawn whose centres lie in the clip rectangle, right and lower edge
///   excluded.
/// - Colours and places are what the corners' are there, by the exact fraction of each. Colours are
///   rounded to the nearest, places down to the texel that they lie in.
///
/// What cannot be meant is left out: triangles with a corner that is not finite or farther than
/// kFarthest from the picture's, indices and commands beyond the ends of their lists, callbacks.
class TrianglePainter {
 public:
  static constexpr int kMaxTexels = 1 << 13;  ///< of the atlas's side
  static constexpr int kFarthest = 1 << 15;   ///< pixels

  /// The picture is no larger than kMaxPictureSide, the atlas not empty.
  void paint(const ImDrawData& data, const GlyphAtlas& atlas, const PixelRows& picture);

 private:
  std::vector<int> texelColumns_;  ///< of one rectangle's columns
};

}  // namespace hearth
