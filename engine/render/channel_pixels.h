#pragma once

#include <span>

#include "render/channel.h"
#include "render/shown_strip.h"
#include "render/span.h"
#include "render/span_painter.h"
#include "render/strip.h"

namespace hearth {

/// Paints a span with a view of the renderer's own numbers.
void paintChannel(const SpanPainter& painter, const Span& span, Channel channel,
                  std::span<const double> climbs, Strip& strip);

/// Notes what the rows of a span show, for marks. Outlines and coverage are those of what lies
/// behind middle textures.
void noteShown(const SpanPainter& painter, const Span& span, Marks marks,
               std::span<const double> climbs, ShownStrip& shown);

}  // namespace hearth
