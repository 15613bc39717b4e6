#pragma once

#include "level/scene.h"
#include "render/shown_columns.h"
#include "render/strip.h"

/// Marks the pixels of a column by what they show.
namespace hearth {

void mark(const Scene& scene, const ShownColumns<ShownTexel>& shown, Strip& strip, int column);
void mark(const Scene& scene, const ShownColumns<ShownSurface>& shown, Strip& strip, int column);
void mark(const Scene& scene, const ShownColumns<ShownTimes>& shown, Strip& strip, int column);

}  // namespace hearth
