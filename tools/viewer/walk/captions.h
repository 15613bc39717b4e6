#pragma once

#include <span>
#include <string>
#include <string_view>

#include "image/pixel_rows.h"
#include "viewer/walk/keys.h"

/// What is written over the picture.
namespace hearth {

/// How many pixels a pixel of letters and lines takes on each side, so that both can be read in
/// large pictures.
int captionScale(const PixelRows& picture);

/// Makes the picture darker, so that what is drawn over it stands out.
void darken(const PixelRows& picture, int left, int top, int right, int bottom);

/// The list of keys, in the middle. What a small picture has no room for is cut off.
void drawKeys(const PixelRows& picture, std::span<const KeyListRow> rows);

/// Lines at the upper edge, broken at `width` pixels. Of more than fit into half of the picture,
/// the first.
void drawNotes(const PixelRows& picture, std::span<const std::string> notes, int width);

/// One line at the lower edge.
void drawMessage(const PixelRows& picture, std::string_view text);

}  // namespace hearth
