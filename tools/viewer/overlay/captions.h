#pragma once

#include <span>
#include <string>
#include <string_view>

#include "image/pixel_rows.h"
#include "viewer/input/actions.h"

/// Text over the picture.
namespace hearth {

/// The factor by which letters and lines are enlarged, so that they stay legible in large pictures.
int captionScale(const PixelRows& picture);

/// Darkens the picture, so that text and lines over it stand out.
void darken(const PixelRows& picture, int left, int top, int right, int bottom);

/// The list of keys, in the middle. A small picture cuts it off.
void drawKeys(const PixelRows& picture, std::span<const KeyListRow> rows);

/// Lines at the upper edge, broken at `width` pixels. If they do not fit into half of the
/// picture, only the first ones show.
void drawNotes(const PixelRows& picture, std::span<const std::string> notes, int width);

/// One line at the lower edge.
void drawMessage(const PixelRows& picture, std::string_view text);

}  // namespace hearth
