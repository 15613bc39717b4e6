#pragma once

#include "level/level.h"
#include "render/shown_columns.h"
#include "render/texture.h"

/// Marks the pixels of a column, which lie one behind the other, by what they show.
namespace hearth {

void mark(const Level& level, const ShownColumns<ShownTexel>& shown, Pixel* pixels);
void mark(const Level& level, const ShownColumns<ShownSurface>& shown, Pixel* pixels);
void mark(const Level& level, const ShownColumns<ShownTimes>& shown, Pixel* pixels);

}  // namespace hearth
