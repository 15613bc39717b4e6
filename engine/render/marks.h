#pragma once

#include "level/level.h"
#include "render/channel.h"
#include "render/shown_strip.h"
#include "render/strip.h"

namespace hearth {

/// Marks the columns of a strip, from its first up to `columnEnd`, by what their pixels show.
void mark(Marks marks, const Level& level, const ShownStrip& shown, int columnEnd, Strip& strip);

}  // namespace hearth
