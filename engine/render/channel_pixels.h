#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "level/scene.h"
#include "math/vec.h"
#include "render/channel.h"
#include "render/shown_columns.h"
#include "render/span.h"
#include "render/span_painter.h"
#include "render/strip.h"

namespace hearth {

/// Numbers the surfaces that show, by SurfaceId: the colours of Channel::Surface do not depend on
/// surfaces that show only at other heights.
std::vector<std::size_t> numbersOfShown(const Scene& scene);

/// A frame that a channel is drawn of.
struct ChannelFrame {
  Channel channel;
  const Level& level;
  Vec3 eye;
  std::span<const std::size_t> surfaceNumbers;  ///< see above; of Surface and Faces alone
  std::span<const double> raySlopes;            ///< see SpanPainter
};

/// Paints a span with a view of the renderer's own numbers.
void paintChannel(const SpanPainter& painter, const Span& span, const ChannelFrame& frame,
                  Strip& strip);

/// Records what the rows of a span show in its column, for marks. Of surfaces and times, masked
/// middle textures and things are left out: they are those behind them.
void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownTexel> column);
void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownSurface> column);
void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownTimes> column);
void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownFace> column);

}  // namespace hearth
