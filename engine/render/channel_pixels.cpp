#include "render/channel_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "math/wrapped.h"
#include "render/renderer.h"

namespace hearth {

namespace {

std::uint8_t rounded(double level) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, 255.0)));
}

/// A colour that differs clearly between neighbouring indices.
Rgb indexColor(std::size_t index) {
  const std::uint32_t mixed = (static_cast<std::uint32_t>(index) + 1) * 2654435761U;
  return {static_cast<std::uint8_t>(64 + (mixed >> 8) % 192),
          static_cast<std::uint8_t>(64 + (mixed >> 16) % 192),
          static_cast<std::uint8_t>(64 + (mixed >> 24) % 192)};
}

Rgb gray(double level) {
  const std::uint8_t value = rounded(level);
  return {value, value, value};
}

/// A colour for each face; darker ones for surfaces, by their numbers.
Rgb faceColor(const Span& span, const ChannelFrame& frame) {
  if (span.face) return indexColor(frame.level.indexOf(*span.face));
  const Rgb surface = indexColor(frame.surfaceNumbers[span.surface.index()]);
  const auto dark = [](std::uint8_t c) { return static_cast<std::uint8_t>(c / 4); };
  return {dark(surface.r), dark(surface.g), dark(surface.b)};
}

/// Out of a surface's front; of sky and sprites none.
Vec3 normalOf(const Span& span, const LitSurface* lit) {
  if (!span.face) return lit ? lit->normal : Vec3{};
  const Vec3 out = frontOf(*span.face);
  return (1 / length(out)) * out;
}

/// The brighter the more a surface faces one corner of the world, so that edges can be seen.
Rgb sideColor(const Span& span, Vec3 normal, Vec3 eye) {
  constexpr Vec3 kBrightSide = {0.36, 0.48, 0.8};  // of length 1
  const bool isBack = span.face && dot(frontOf(*span.face), eye - span.face->corners.front()) < 0;
  const double level = 160 + (isBack ? -72 : 72) * dot(normal, kBrightSide);
  return isBack ? Rgb{rounded(level), 0, 0} : gray(level);
}

Rgb normalColor(Vec3 n) {
  return {rounded(127.5 * (n.x + 1)), rounded(127.5 * (n.y + 1)), rounded(127.5 * (n.z + 1))};
}

Rgb uvColor(const SpanMapping& mapping, double parameter, const Texture& image) {
  const auto fraction = [](double x, int size) {
    return static_cast<std::uint8_t>(255 * (x / size - std::floor(x / size)));
  };
  const double v = mapping.isSky ? mapping.skyV(parameter, image) : mapping.v.at(parameter);
  return {fraction(mapping.u.at(parameter), image.width()), fraction(v, image.height()), 0};
}

Rgb lightColor(const Lightmap* lightmap, const SpanMapping& mapping, double parameter) {
  if (!lightmap) return {};
  const auto level = [&](int channel) {
    return rounded(lightmap->sample(mapping.s.at(parameter), mapping.t.at(parameter), channel));
  };
  return {level(0), level(1), level(2)};
}

/// Metres.
double depthOf(const SpanMapping& mapping, double parameter) {
  return mapping.isPlane ? parameter : mapping.depth;
}

/// Whether it is painted over what bounds the air.
bool liesOverLevel(SurfaceKind kind) { return kind == SurfaceKind::MaskedMiddle || isThing(kind); }

bool isHole(const SpanMapping& mapping, double parameter, const Texture& image) {
  const int x = wrapped(mapping.u.at(parameter), image.width());
  const int y = wrapped(mapping.v.at(parameter), image.height());
  return (image.texels()[x * image.height() + y] & kHoleBit) != 0;
}

/// floor(texel), without a call for each, as std::floor is.
std::int64_t lineBefore(double texel) {
  const auto towardsZero = static_cast<std::int64_t>(texel);
  return towardsZero - (texel < static_cast<double>(towardsZero) ? 1 : 0);
}

/// Of what there is one for each row of a picture, those of a span.
template <typename T>
std::span<T> rowsOf(const Span& span, std::span<T> rows) {
  return rows.subspan(static_cast<std::size_t>(span.rowBegin),
                      static_cast<std::size_t>(span.rowEnd - span.rowBegin));
}

}  // namespace

std::vector<std::size_t> numbersOfShown(const Scene& scene) {
  std::vector<std::size_t> numbers(scene.level().surfaces.size());
  std::size_t shown = 0;
  for (const SurfaceId id : scene.shownSurfaces()) numbers[id.index()] = shown++;
  return numbers;
}

void paintChannel(const SpanPainter& painter, const Span& span, const ChannelFrame& frame,
                  Strip& strip) {
  const Material material = painter.materialOf(span);
  const SpanMapping mapping = painter.mappingOf(material, span);
  const bool hasHoles = mayHaveHoles(material.surface.kind);
  if (liesOverLevel(material.surface.kind) && frame.channel == Channel::Overdraw) return;
  for (int row = span.rowBegin; row < span.rowEnd; ++row) {
    const double parameter = mapping.parameterAt(frame.raySlopes[static_cast<std::size_t>(row)]);
    if (hasHoles && isHole(mapping, parameter, material.image())) continue;
    Rgb pixel = fromXrgb(*strip.at(span.column, row));
    switch (frame.channel) {
      case Channel::Sector:
        pixel = indexColor(material.surface.sector.index());
        break;
      case Channel::Surface:
        pixel = indexColor(frame.surfaceNumbers[span.surface.index()]);
        break;
      case Channel::Faces:
        pixel = faceColor(span, frame);
        break;
      case Channel::Depth:
        pixel = gray(255 / (1 + depthOf(mapping, parameter)));
        break;
      case Channel::Uv:
        pixel = uvColor(mapping, parameter, material.image());
        break;
      case Channel::Normal:
        pixel = normalColor(normalOf(span, material.lit.surface));
        break;
      case Channel::Backs:
        pixel = sideColor(span, normalOf(span, material.lit.surface), frame.eye);
        break;
      case Channel::Light:
        pixel = lightColor(material.lightmap, mapping, parameter);
        break;
      case Channel::Overdraw:
        pixel = pixel == kHole ? Rgb{0, 160, 0} : Rgb{255, 0, 0};
        break;
    }
    *strip.at(span.column, row) = toXrgb(pixel);
  }
}

void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownTexel> column) {
  const Material material = painter.materialOf(span);
  const SpanMapping mapping = painter.mappingOf(material, span);
  const bool hasHoles = mayHaveHoles(material.surface.kind);
  const auto surface = material.lit ? std::optional(span.surface) : std::nullopt;
  const std::span rows = rowsOf(span, column);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double parameter = mapping.parameterAt(rowsOf(span, raySlopes)[k]);
    if (hasHoles && isHole(mapping, parameter, material.image())) continue;
    rows[k].surface = surface;
    const Vec2 texel{mapping.s.at(parameter), mapping.t.at(parameter)};
    rows[k].texel = texel;
    rows[k].lines = {lineBefore(texel.x), lineBefore(texel.y)};
  }
}

void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownSurface> column) {
  const Material material = painter.materialOf(span);
  if (liesOverLevel(material.surface.kind)) return;
  const SpanMapping mapping = painter.mappingOf(material, span);
  const std::span rows = rowsOf(span, column);
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k] = {span.surface, depthOf(mapping, mapping.parameterAt(rowsOf(span, raySlopes)[k]))};
}

void noteShown(const SpanPainter& painter, const Span& span, std::span<const double>,
               std::span<ShownTimes> column) {
  if (liesOverLevel(painter.materialOf(span).surface.kind)) return;
  for (ShownTimes& row : rowsOf(span, column)) ++row.times;
}

void noteShown(const SpanPainter& painter, const Span& span, std::span<const double> raySlopes,
               std::span<ShownFace> column) {
  const Material material = painter.materialOf(span);
  const std::span rows = rowsOf(span, column);
  if (!mayHaveHoles(material.surface.kind)) {
    std::ranges::fill(rows, ShownFace{span.face});
    return;
  }
  const SpanMapping mapping = painter.mappingOf(material, span);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double parameter = mapping.parameterAt(rowsOf(span, raySlopes)[k]);
    if (!isHole(mapping, parameter, material.image())) rows[k] = {};
  }
}

}  // namespace hearth
