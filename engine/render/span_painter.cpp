#include "render/span_painter.h"

#include <algorithm>

#include "math/planted_bug.h"
#include "render/lit_pixel.h"

namespace hearth {

namespace {

/// The texels that a batch shows.
class TexelsOf {
 public:
  TexelsOf(const Image& image, const RowBatch& batch)
      : pixels_(image.pixels().data()),
        width_(static_cast<std::size_t>(image.width())),
        batch_(batch) {}

  Rgb operator()(std::size_t k) const {
    return pixels_[static_cast<std::size_t>(batch_.texelRow[k]) * width_ +
                   static_cast<std::size_t>(batch_.texelColumn[k])];
  }

 private:
  const Rgb* pixels_;
  std::size_t width_;
  const RowBatch& batch_;
};

/// The light of a batch's pixels, of a lightmap with so many channels.
template <int kChannels>
class SharesOf {
 public:
  SharesOf(const Lightmap& lightmap, double sectorLight, const RowBatch& batch)
      : levels_(lightmap.levels.data()),
        bytesPerRow_(static_cast<std::size_t>(lightmap.rect.width) * kChannels),
        sectorLight_(sameChannels(static_cast<float>(sectorLight))),
        batch_(batch) {}

  Channels operator()(std::size_t k) const {
    const std::uint8_t* upper = levels_ +
                                static_cast<std::size_t>(batch_.lightRow.texel[k]) * bytesPerRow_ +
                                static_cast<std::size_t>(batch_.lightColumn.texel[k]) * kChannels;
    const std::uint8_t* lower = upper + bytesPerRow_;
    const Channels across = sameChannels(batch_.lightColumn.share[k]);
    const Channels above =
        mixed(lightTexel<kChannels>(upper), lightTexel<kChannels>(upper + kChannels), across);
    const Channels below =
        mixed(lightTexel<kChannels>(lower), lightTexel<kChannels>(lower + kChannels), across);
    return lightShares(mixed(above, below, sameChannels(batch_.lightRow.share[k])), sectorLight_);
  }

 private:
  const std::uint8_t* levels_;
  std::size_t bytesPerRow_;
  Channels sectorLight_;
  const RowBatch& batch_;
};

/// `colorAt(k)` and `sharesAt(k)` are of the batch's row k, which lies in the strip at
/// `pixels[k * Strip::kColumns]`.
template <typename ColorAt, typename SharesAt>
void shade(Rgb* pixels, const RowBatch& batch, ColorAt colorAt, SharesAt sharesAt) {
  for (std::size_t k = 0; k < batch.count; ++k)
    putShaded(&pixels[k * Strip::kColumns], colorAt(k), sharesAt(k));
}

template <typename ColorAt>
void shade(Rgb* pixels, const RowBatch& batch, const Material& material, ColorAt colorAt) {
  if (!material.lightmap) {
    const Channels shares =
        lightShares(sameChannels(0), sameChannels(static_cast<float>(material.sectorLight)));
    return shade(pixels, batch, colorAt, [shares](std::size_t) { return shares; });
  }
  const Lightmap& lightmap = *material.lightmap;
  if (lightmap.channels == 1)
    return shade(pixels, batch, colorAt, SharesOf<1>(lightmap, material.sectorLight, batch));
  shade(pixels, batch, colorAt, SharesOf<3>(lightmap, material.sectorLight, batch));
}

void paintBatch(Rgb* pixels, RowBatch& batch, const SpanMapping& mapping, const Material& material,
                LightMode mode) {
  if (mode != LightMode::Only) findTexels(batch, mapping, material.image);
  const TexelsOf texels(material.image, batch);
  if (mode == LightMode::None) {
    for (std::size_t k = 0; k < batch.count; ++k) pixels[k * Strip::kColumns] = texels(k);
    return;
  }
  if (material.lightmap) findLightPlaces(batch, mapping, material.lightmap->rect);
  if (mode == LightMode::Both)
    return shade(pixels, batch, material, [&](std::size_t k) { return channelsOf(texels(k)); });
  shade(pixels, batch, material, [](std::size_t) { return sameChannels(255); });
}

}  // namespace

void SpanPainter::paint(const Span& span, LightMode mode, Strip& strip) const {
  const Material material = materialOf(span.surface);
  const SpanMapping mapping = mappingOf(material, span);
  RowBatch batch;
  for (int row = span.rowBegin; row < span.rowEnd; row += static_cast<int>(RowBatch::kRows)) {
    batch.firstRow = row;
    batch.count = std::min(RowBatch::kRows, static_cast<std::size_t>(span.rowEnd - row));
    findMeasures(batch, mapping, climbs_);
    paintBatch(strip.at(span.column, row), batch, mapping, material, mode);
  }
}

Material SpanPainter::materialOf(SurfaceId id) const {
  const Surface& surface = level_[id];
  const auto& lit = light_.surfaces[id.index()];
  const auto& lightmap = light_.lightmaps[id.index()];
  return {surface, textures_[surface.mapping.texture.index()], lightmap ? &*lightmap : nullptr,
          lit ? &*lit : nullptr, sectorLightOn(surface)};
}

double SpanPainter::sectorLightOn(const Surface& surface) const {
  const bool step =
      surface.kind == SurfaceKind::LowerStep || surface.kind == SurfaceKind::UpperStep;
  if (planted(PlantedBug::SectorLightForgottenOnSteps) && step) return 0;
  return isSky(surface.kind) ? 1 : level_[surface.sector].light;
}

}  // namespace hearth
