#pragma once

#include <string_view>

#include "image/pixel_rows.h"

namespace hearth {

/// Pixels from the top of a line of text to the bottom of its lowest letters: stb_easy_font's.
inline constexpr int kTextHeight = 9;

/// Pixels that `drawText` takes. Signs that are not printable ASCII show as `?`, one for each byte.
int textWidth(std::string_view text);

/// Draws one line of small letters, its left top corner at (x, y). What lies outside the picture
/// is cut off. With `scale`, each of their pixels is a square of so many.
void drawText(const PixelRows& picture, int x, int y, std::string_view text, Rgb color,
              int scale = 1);

}  // namespace hearth
