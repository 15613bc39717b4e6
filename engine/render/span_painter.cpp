#include "render/span_painter.h"

#include <algorithm>
#include <optional>

#include "render/footprint.h"

namespace hearth {

namespace {

constexpr Rgb kWhite = {255, 255, 255};

void count(const Span& span, const Material& material, PaintStats& stats) {
  const SurfaceKind kind = material.surface.kind;
  if (isSlope(kind) || isSidewall(kind)) ++stats.slopeSpans;
  const auto rows = static_cast<std::size_t>(span.rowEnd - span.rowBegin);
  stats.pixels += rows;
  if (!material.hasVaryingLight()) return;
  ++stats.lightmapSpans;
  if (material.lightmap->channels == 3) ++stats.coloredSpans;
  stats.lightmapPixels += rows;
}

/// The size of the texture that fits the first row. Only the rows that it fits stay in the batch.
const Texture& fitting(const MipMap& texture, const Footprint& footprint, RowBatch& batch) {
  const int level = footprint.mipLevelAt(batch.parameters[0]);
  const std::span parameters(batch.parameters, batch.count);
  const auto fits = [&](double parameter) { return footprint.mipLevelAt(parameter) == level; };
  batch.count =
      static_cast<std::size_t>(std::ranges::partition_point(parameters, fits) - parameters.begin());
  return texture.level(level);
}

}  // namespace

void SpanPainter::paint(const Span& span, LightMode mode, RowBatch& batch, Strip& strip,
                        PaintStats& stats) const {
  Material material = materialOf(span.surface);
  if (mode == LightMode::None) {
    material.lightmap = nullptr;
    material.sectorLight = 1;
  }
  // Without light that differs from pixel to pixel there is no lightmap to be mapped to.
  if (!material.hasVaryingLight()) material.lit = nullptr;
  count(span, material, stats);
  const SpanMapping mapping = mappingOf(material, span);
  // Between the texels of a hole and of its edge nothing is mixed: it would be half a hole.
  const bool hasHoles = material.surface.kind == SurfaceKind::MaskedMiddle;
  const TextureFilter filter = hasHoles ? TextureFilter::Nearest : settings_.textureFilter;
  std::optional<Footprint> footprint;
  if (filter == TextureFilter::Mipmapped && mode != LightMode::Only)
    footprint.emplace(scene_, projection_, span, material.image(), mapping);
  if (!material.hasVaryingLight())
    kernels_.showEvenly(batch, material.lightmap, material.sectorLight);
  for (int row = span.rowBegin; row < span.rowEnd; row += static_cast<int>(batch.count)) {
    batch.count = std::min(RowBatch::kRows, static_cast<std::size_t>(span.rowEnd - row));
    findParameters(row, mapping, batch);
    const Texture& image =
        footprint ? fitting(material.texture, *footprint, batch) : material.image();
    if (mode != LightMode::Only || hasHoles)
      findTexels(filter, material.image(), image, mapping, batch);
    if (material.hasVaryingLight()) findShown(material, mapping, batch);
    Pixel* const pixels = strip.at(span.column, row);
    if (hasHoles)
      shadeAroundHoles(image, mode, batch, pixels);
    else
      shade(filter, image, mode, batch, pixels);
  }
}

void SpanPainter::findParameters(int firstRow, const SpanMapping& mapping, RowBatch& batch) const {
  const double* const raySlopes = &raySlopes_[static_cast<std::size_t>(firstRow)];
  if (mapping.isPlane)
    kernels_.findDepths(batch, mapping, raySlopes);
  else
    batch.parameters = raySlopes;
}

void SpanPainter::findTexels(TextureFilter filter, const Texture& full, const Texture& image,
                             const SpanMapping& mapping, RowBatch& batch) const {
  switch (filter) {
    case TextureFilter::Nearest:
      return kernels_.findTexels(batch, mapping, image);
    case TextureFilter::Bilinear:
      return kernels_.findTexelsAround(batch, mapping, image);
    case TextureFilter::Mipmapped:
      return kernels_.findTexels(batch, onImage(mapping, full, image), image);
  }
}

void SpanPainter::findShown(const Material& material, const SpanMapping& mapping,
                            RowBatch& batch) const {
  const Lightmap& lightmap = *material.lightmap;
  if (mapping.isPlane) {
    kernels_.findLightTexels(batch, mapping, lightmap, settings_.lightFilter);
    kernels_.findShown(batch, lightmap, material.sectorLight);
  } else {
    kernels_.findLightRows(batch, mapping, lightmap, settings_.lightFilter);
    kernels_.findShownUpright(batch, lightmap, material.sectorLight);
  }
}

void SpanPainter::shade(TextureFilter filter, const Texture& image, LightMode mode,
                        const RowBatch& batch, Pixel* pixels) const {
  if (mode == LightMode::Only)
    kernels_.shadeColor(pixels, batch, kWhite);
  else if (filter == TextureFilter::Bilinear)
    kernels_.shadeMixtures(pixels, batch, image);
  else
    kernels_.shadeTexels(pixels, batch, image);
}

void SpanPainter::shadeAroundHoles(const Texture& image, LightMode mode, const RowBatch& batch,
                                   Pixel* pixels) const {
  RowBatch::Rows<Pixel> shaded;
  shade(TextureFilter::Nearest, image, mode, batch, shaded.data());
  for (std::size_t k = 0; k < batch.count; ++k)
    if ((image.texels()[batch.texels.upperLeft[k]] & kHoleBit) == 0) pixels[k] = shaded[k];
}

Material SpanPainter::materialOf(SurfaceId id) const {
  const Surface& surface = scene_[id];
  const auto& lit = light_.surfaces[id.index()];
  const auto& lightmap = light_.lightmaps[id.index()];
  return {surface, textures_[surface.mapping.texture.index()], lightmap ? &*lightmap : nullptr,
          lit ? &*lit : nullptr, sectorLightOn(surface)};
}

double SpanPainter::sectorLightOn(const Surface& surface) const {
  return isSky(surface.kind) ? 1 : scene_[surface.sector].light;
}

}  // namespace hearth
