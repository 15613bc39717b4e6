#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "import/doom/palette.h"
#include "import/doom/picture.h"
#include "import/doom/wad.h"

namespace hearth::doom {

/// What a patch says of itself, in pixels.
struct PatchHeader {
  int width;
  int height;
  /// Where a thing stands that shows the patch, from the patch's left border to the right and from
  /// its upper border down.
  int left;
  int top;
};

/// The error is what there is to say of the patch ("has 3 bytes ..."). Columns are not looked at.
tl::expected<PatchHeader, std::string> readPatchHeader(Bytes patch);

/// The width that a patch says it has; 0 of one that has no header.
int widthOfPatch(Bytes patch);

/// Draws a patch over a picture, from column `left` on; where it begins in each of the picture's
/// columns, `tops` says. What lies outside the picture is cut off; above it, as in Doom, each post
/// loses as many rows as are outside, but at its lower end.
///
/// A patch (https://doomwiki.org/wiki/Picture_format) is a picture with holes, by columns:
///
///     int16 width, height, left and top, of which the last two are for sprites
///     int32 where each column begins, counted from the start of the patch
///
/// A column is a list of posts, the stretches of it that are not holes, from top to bottom:
///
///     byte  row of its first pixel, or 255 behind the last post
///     byte  how many pixels; then one unused byte, the pixels, and another unused one
///
/// Rows beyond 254 do not fit in a byte. So in tall patches a row that is not below that of the
/// post before is counted from there. As in Doom, the height in the header cuts nothing off.
///
/// Returns the first mistake, as what there is to say of the patch ("has 3 bytes ..."): of columns
/// with one, all posts above it are drawn.
std::optional<std::string> drawPatch(Bytes patch, int left, std::span<const int> tops,
                                     const Palette& palette, Picture& picture);

}  // namespace hearth::doom
