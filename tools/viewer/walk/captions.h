#pragma once

#include <span>
#include <string>
#include <string_view>

#include "image/image.h"
#include "viewer/walk/keys.h"

/// What is written over the picture.
namespace hearth {

/// How many pixels a pixel of letters and lines takes on each side, so that both can be read in
/// large pictures.
int captionScale(const Image& picture);

/// Makes the picture darker, so that what is drawn over it stands out.
void darken(Image& picture, int left, int top, int right, int bottom);

/// The list of keys, in the middle. What a small picture has no room for is cut off.
void drawKeys(Image& picture, std::span<const KeyListRow> rows);

/// Lines at the upper edge, broken at `width` pixels. Of more than fit into half of the picture,
/// the first.
void drawNotes(Image& picture, std::span<const std::string> notes, int width);

/// One line at the lower edge.
void drawMessage(Image& picture, std::string_view text);

}  // namespace hearth
