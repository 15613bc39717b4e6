#include "render/span_painter.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "render/footprint.h"

namespace hearth {

namespace {

constexpr Rgb kWhite = {255, 255, 255};

void count(const Span& span, const Material& material, PaintStats& stats) {
  const SurfaceKind kind = material.surface.kind;
  if (isSlope(kind) || isSidewall(kind)) ++stats.slopeSpans;
  const auto rows = static_cast<std::size_t>(span.rowEnd - span.rowBegin);
  stats.pixels += rows;
  if (!material.hasUnevenLight()) return;
  ++stats.lightmapSpans;
  if (material.lightmap->channels == 3) ++stats.coloredSpans;
  stats.lightmapPixels += rows;
}

/// Calls `between(begin, end)` for every so many rows; the last row ends the last of them.
template <typename Between>
void forEachInterval(std::size_t rows, int every, Between&& between) {
  const std::size_t last = rows - 1;
  for (std::size_t begin = 0; begin < last;) {
    const std::size_t end = std::min(begin + static_cast<std::size_t>(every), last);
    between(begin, end);
    begin = end;
  }
}

/// Gives the rows after `begin` and before `end` what lies evenly between these.
template <typename T>
void interpolate(RowBatch::Rows<T>& rows, std::size_t begin, std::size_t end) {
  const T step = (rows[end] - rows[begin]) / static_cast<T>(end - begin);
  for (std::size_t k = begin + 1; k < end; ++k)
    rows[k] = rows[begin] + static_cast<T>(k - begin) * step;
}

/// Gives so many rows what lies evenly between those of every so many of them, which come first.
void spread(RowBatch::Rows<float>& values, std::size_t rows, int every) {
  const RowBatch::Rows<float> found = values;
  std::size_t next = 1;
  forEachInterval(rows, every, [&](std::size_t begin, std::size_t end) {
    values[end] = found[next++];
    interpolate(values, begin, end);
  });
}

/// The size of the texture that fits the first row. Only the rows that it fits stay in the batch.
const Texture& fitting(const MipMap& texture, const Footprint& footprint, RowBatch& batch) {
  const int level = footprint.levelAt(batch.measures[0]);
  const std::span measures(batch.measures, batch.count);
  const auto fits = [&](double measure) { return footprint.levelAt(measure) == level; };
  batch.count =
      static_cast<std::size_t>(std::ranges::partition_point(measures, fits) - measures.begin());
  return texture.level(level);
}

}  // namespace

void findDepthsEvery(int every, RowBatch& batch, const SpanMapping& mapping, const double* climbs) {
  batch.measures = batch.depths.data();
  batch.depths[0] = mapping.depthAt(climbs[0]);
  forEachInterval(batch.count, every, [&](std::size_t begin, std::size_t end) {
    batch.depths[end] = mapping.depthAt(climbs[end]);
    interpolate(batch.depths, begin, end);
  });
}

void SpanPainter::paint(const Span& span, LightMode mode, RowBatch& batch, Strip& strip,
                        PaintStats& stats) const {
  Material material = materialOf(span.surface);
  if (mode == LightMode::None) {
    material.lightmap = nullptr;
    material.sectorLight = 1;
  }
  // Without light that differs from pixel to pixel there is no lightmap to be mapped to.
  if (!material.hasUnevenLight()) material.lit = nullptr;
  count(span, material, stats);
  const SpanMapping mapping = mappingOf(material, span);
  // Between the texels of a hole and of its edge nothing is mixed: it would be half a hole.
  const bool hasHoles = material.surface.kind == SurfaceKind::Middle;
  const TextureFilter filter = hasHoles ? TextureFilter::Nearest : settings_.textureFilter;
  std::optional<Footprint> footprint;
  if (filter == TextureFilter::Mipmapped && mode != LightMode::Only)
    footprint.emplace(level_, projection_, span, material.image(), mapping);
  if (!material.hasUnevenLight())
    kernels_.showEvenly(batch, material.lightmap, material.sectorLight);
  for (int row = span.rowBegin; row < span.rowEnd; row += static_cast<int>(batch.count)) {
    batch.count = std::min(RowBatch::kRows, static_cast<std::size_t>(span.rowEnd - row));
    findMeasures(row, mapping, batch);
    const Texture& image =
        footprint ? fitting(material.texture, *footprint, batch) : material.image();
    if (mode != LightMode::Only || hasHoles)
      findTexels(filter, material.image(), image, mapping, batch);
    if (material.hasUnevenLight()) stats.lightLookups += findShown(material, mapping, batch);
    Pixel* const pixels = strip.at(span.column, row);
    if (hasHoles)
      shadeAroundHoles(image, mode, batch, pixels);
    else
      shade(filter, image, mode, batch, pixels);
  }
}

void SpanPainter::findMeasures(int firstRow, const SpanMapping& mapping, RowBatch& batch) const {
  batch.measures = &climbs_[static_cast<std::size_t>(firstRow)];
  if (!mapping.isPlane) return;
  if (settings_.depthEvery == 1) return places_.findDepths(batch, mapping, batch.measures);
  findDepthsEvery(settings_.depthEvery, batch, mapping, batch.measures);
}

void SpanPainter::findTexels(TextureFilter filter, const Texture& full, const Texture& image,
                             const SpanMapping& mapping, RowBatch& batch) const {
  switch (filter) {
    case TextureFilter::Nearest:
      return places_.findTexels(batch, mapping, image);
    case TextureFilter::Bilinear:
      return places_.findTexelsAround(batch, mapping, image);
    case TextureFilter::Mipmapped:
      return places_.findTexels(batch, onImage(mapping, full, image), image);
  }
}

std::size_t SpanPainter::findShown(const Material& material, const SpanMapping& mapping,
                                   RowBatch& batch) const {
  if (settings_.lightEvery > 1) return findShownEvery(material, mapping, batch);
  findShownInEachRow(material, mapping, batch);
  return batch.count;
}

void SpanPainter::findShownInEachRow(const Material& material, const SpanMapping& mapping,
                                     RowBatch& batch) const {
  const Lightmap& lightmap = *material.lightmap;
  if (mapping.isPlane) {
    places_.findLightTexels(batch, mapping, lightmap, settings_.lightFilter);
    kernels_.findShown(batch, lightmap, material.sectorLight);
  } else {
    places_.findLightRows(batch, mapping, lightmap, settings_.lightFilter);
    kernels_.findShownUpright(batch, lightmap, material.sectorLight);
  }
}

std::size_t SpanPainter::findShownEvery(const Material& material, const SpanMapping& mapping,
                                        RowBatch& batch) const {
  const std::size_t rows = batch.count;
  const double* const measures = batch.measures;
  RowBatch::Rows<double> fewer{measures[0]};
  batch.count = 1;
  forEachInterval(rows, settings_.lightEvery,
                  [&](std::size_t, std::size_t end) { fewer[batch.count++] = measures[end]; });
  batch.measures = fewer.data();
  findShownInEachRow(material, mapping, batch);
  const std::size_t lookups = std::exchange(batch.count, rows);
  batch.measures = measures;
  for (RowBatch::Rows<float>& shown : batch.shown) spread(shown, rows, settings_.lightEvery);
  return lookups;
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
  const Surface& surface = level_[id];
  const auto& lit = light_.surfaces[id.index()];
  const auto& lightmap = light_.lightmaps[id.index()];
  return {surface, textures_[surface.mapping.texture.index()], lightmap ? &*lightmap : nullptr,
          lit ? &*lit : nullptr, sectorLightOn(surface)};
}

double SpanPainter::sectorLightOn(const Surface& surface) const {
  return isSky(surface.kind) ? 1 : level_[surface.sector].light;
}

}  // namespace hearth
