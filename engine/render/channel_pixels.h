#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "level/scene.h"
#include "render/channel.h"
#include "render/shown_columns.h"
#include "render/span.h"
#include "render/span_painter.h"
#include "render/strip.h"

namespace hearth {

/// Numbers the surfaces that show, by SurfaceId: the colours of Channel::Surface do not depend on
/// surfaces that show only at other heights.
std::vector<std::size_t> numbersOfShown(const Scene& scene);

/// Paints a span with a view of the renderer's own numbers.
void paintChannel(const SpanPainter& painter, const Span& span, Channel channel,
                  std::span<const std::size_t> surfaceNumbers, std::span<const double> raySlopes,
                  Strip& strip);

/// Records what the rows of a span show in its column, for marks. Masked middle textures are left
/// out: surfaces and times are those behind them.
void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownTexel> column);
void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownSurface> column);
void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownTimes> column);

}  // namespace hearth
