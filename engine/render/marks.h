#pragma once

#include "level/scene.h"
#include "render/shown_columns.h"
#include "render/texture.h"

/// Marks the pixels of a column, which lie one behind the other, by what they show.
namespace hearth {

void mark(const Scene& scene, const ShownColumns<ShownTexel>& shown, Pixel* pixels);
void mark(const Scene& scene, const ShownColumns<ShownSurface>& shown, Pixel* pixels);
void mark(const Scene& scene, const ShownColumns<ShownTimes>& shown, Pixel* pixels);

}  // namespace hearth
