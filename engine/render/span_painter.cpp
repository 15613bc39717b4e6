#include "render/span_painter.h"

#include <algorithm>

#include "math/planted_bug.h"
#include "render/lit_pixel.h"

namespace hearth {

namespace {

// What every pixel calls is inlined by force: a call costs as much as it does.

/// The texels of an image by row and column.
class Texels {
 public:
  explicit Texels(const Image& image)
      : pixels_(image.pixels().data()), width_(static_cast<std::size_t>(image.width())) {}

  Rgb at(std::int32_t column, std::int32_t row) const {
    return pixels_[static_cast<std::size_t>(row) * width_ + static_cast<std::size_t>(column)];
  }

 private:
  const Rgb* pixels_;
  std::size_t width_;
};

/// The texels that the rows of a batch fall into.
class NearestTexels {
 public:
  NearestTexels(const Image& image, const RowBatch& batch) : texels_(image), batch_(batch) {}

  [[gnu::always_inline]] Rgb texel(std::size_t k) const {
    return texels_.at(batch_.texelColumn.texel[k], batch_.texelRow.texel[k]);
  }
  [[gnu::always_inline]] Channels operator()(std::size_t k) const { return channelsOf(texel(k)); }

 private:
  Texels texels_;
  const RowBatch& batch_;
};

/// Mixtures of the four texels around the rows of a batch.
class MixedTexels {
 public:
  MixedTexels(const Image& image, const RowBatch& batch, bool isSky)
      : texels_(image),
        lastColumn_(image.width() - 1),
        lastRow_(image.height() - 1),
        rowAfterLast_(isSky ? lastRow_ : 0),
        batch_(batch) {}

  [[gnu::always_inline]] Channels operator()(std::size_t k) const {
    const std::int32_t left = batch_.texelColumn.texel[k];
    const std::int32_t right = left == lastColumn_ ? 0 : left + 1;
    const std::int32_t upper = batch_.texelRow.texel[k];
    const std::int32_t lower = upper == lastRow_ ? rowAfterLast_ : upper + 1;
    const Channels across = sameChannels(batch_.texelColumn.share[k]);
    const Channels above = mixed(at(left, upper), at(right, upper), across);
    const Channels below = mixed(at(left, lower), at(right, lower), across);
    return mixed(above, below, sameChannels(batch_.texelRow.share[k]));
  }

 private:
  Channels at(std::int32_t column, std::int32_t row) const {
    return channelsOf(texels_.at(column, row));
  }

  Texels texels_;
  std::int32_t lastColumn_;
  std::int32_t lastRow_;
  std::int32_t rowAfterLast_;
  const RowBatch& batch_;
};

/// The light of a batch's rows, of a lightmap with so many channels.
template <int kChannels, LightFilter kFilter>
class LightmapShares {
 public:
  LightmapShares(const Lightmap& lightmap, double sectorLight, const RowBatch& batch)
      : levels_(lightmap.levels.data()),
        bytesPerRow_(static_cast<std::size_t>(lightmap.rect.width) * kChannels),
        sectorLight_(sameChannels(static_cast<float>(sectorLight))),
        batch_(batch) {}

  [[gnu::always_inline]] Channels operator()(std::size_t k) const {
    const float across = batch_.lightColumn.share[k];
    const float down = batch_.lightRow.share[k];
    const std::uint8_t* upper = levels_ +
                                static_cast<std::size_t>(batch_.lightRow.texel[k]) * bytesPerRow_ +
                                static_cast<std::size_t>(batch_.lightColumn.texel[k]) * kChannels;
    return lightShares(kFilter == LightFilter::Nearest ? nearest(upper, across, down)
                                                       : mixture(upper, across, down),
                       sectorLight_);
  }

 private:
  [[gnu::always_inline]] Channels nearest(const std::uint8_t* upper, float across,
                                          float down) const {
    return lightTexel<kChannels>(upper + (across < 0.5F ? 0 : kChannels) +
                                 (down < 0.5F ? 0 : bytesPerRow_));
  }

  [[gnu::always_inline]] Channels mixture(const std::uint8_t* upper, float across,
                                          float down) const {
    const std::uint8_t* lower = upper + bytesPerRow_;
    const Channels right = sameChannels(across);
    const Channels above =
        mixed(lightTexel<kChannels>(upper), lightTexel<kChannels>(upper + kChannels), right);
    const Channels below =
        mixed(lightTexel<kChannels>(lower), lightTexel<kChannels>(lower + kChannels), right);
    return mixed(above, below, sameChannels(down));
  }

  const std::uint8_t* levels_;
  std::size_t bytesPerRow_;
  Channels sectorLight_;
  const RowBatch& batch_;
};

/// The light of every so many rows of a batch, and of those in between what lies evenly between.
/// Asked for one row after the other.
template <typename SharesAt>
class InterpolatedShares {
 public:
  InterpolatedShares(SharesAt sharesAt, int every, std::size_t count)
      : sharesAt_(sharesAt), every_(static_cast<std::size_t>(every)), last_(count - 1) {}

  Channels operator()(std::size_t k) {
    if (k == next_) {
      here_ = k == 0 ? sharesAt_(0) : there_;
      next_ = std::min(k + every_, last_);
      if (next_ == k) return here_;
      there_ = sharesAt_(next_);
      step_ = _mm_div_ps(_mm_sub_ps(there_, here_), sameChannels(static_cast<float>(next_ - k)));
      begin_ = k;
    }
    return _mm_add_ps(here_, _mm_mul_ps(sameChannels(static_cast<float>(k - begin_)), step_));
  }

 private:
  SharesAt sharesAt_;
  std::size_t every_;
  std::size_t last_;
  std::size_t begin_ = 0;
  std::size_t next_ = 0;
  Channels here_{};
  Channels there_{};
  Channels step_{};
};

/// `colorAt(k)` and `sharesAt(k)` are of the batch's row k, which lies in the strip at
/// `pixels[k * Strip::kColumns]`.
template <typename ColorAt, typename SharesAt>
void shade(Rgb* pixels, const RowBatch& batch, ColorAt colorAt, SharesAt sharesAt) {
  for (std::size_t k = 0; k < batch.count; ++k)
    putShaded(&pixels[k * Strip::kColumns], colorAt(k), sharesAt(k));
}

template <typename ColorAt, typename SharesAt>
void shadeEvery(int rows, Rgb* pixels, const RowBatch& batch, ColorAt colorAt, SharesAt sharesAt) {
  if (rows == 1) return shade(pixels, batch, colorAt, sharesAt);
  shade(pixels, batch, colorAt, InterpolatedShares(sharesAt, rows, batch.count));
}

template <int kChannels, typename ColorAt>
void shadeWithLightmap(Rgb* pixels, const RowBatch& batch, const Material& material,
                       const DrawSettings& settings, ColorAt colorAt) {
  const auto with = [&](auto sharesAt) {
    shadeEvery(settings.lightEvery, pixels, batch, colorAt, sharesAt);
  };
  if (settings.lightFilter == LightFilter::Bilinear)
    with(LightmapShares<kChannels, LightFilter::Bilinear>(*material.lightmap, material.sectorLight,
                                                          batch));
  else
    with(LightmapShares<kChannels, LightFilter::Nearest>(*material.lightmap, material.sectorLight,
                                                         batch));
}

/// The levels of a lightmap that is even, or of none.
Channels evenLevels(const Lightmap* lightmap) {
  if (!lightmap) return sameChannels(0);
  const std::uint8_t* texel = lightmap->levels.data();
  return lightmap->channels == 1 ? lightTexel<1>(texel) : lightTexel<3>(texel);
}

template <typename ColorAt>
void shade(Rgb* pixels, const RowBatch& batch, const Material& material,
           const DrawSettings& settings, ColorAt colorAt) {
  if (!material.hasUnevenLight()) {
    const Channels shares = lightShares(evenLevels(material.lightmap),
                                        sameChannels(static_cast<float>(material.sectorLight)));
    return shade(pixels, batch, colorAt, [shares](std::size_t) { return shares; });
  }
  if (material.lightmap->channels == 1)
    return shadeWithLightmap<1>(pixels, batch, material, settings, colorAt);
  shadeWithLightmap<3>(pixels, batch, material, settings, colorAt);
}

void paintNearest(Rgb* pixels, RowBatch& batch, const SpanMapping& mapping,
                  const Material& material, const DrawSettings& settings, LightMode mode) {
  findTexels(batch, mapping, material.image);
  const NearestTexels texels(material.image, batch);
  if (mode == LightMode::Both) return shade(pixels, batch, material, settings, texels);
  for (std::size_t k = 0; k < batch.count; ++k) pixels[k * Strip::kColumns] = texels.texel(k);
}

void paintMixed(Rgb* pixels, RowBatch& batch, const SpanMapping& mapping, const Material& material,
                const DrawSettings& settings, LightMode mode) {
  findMixtures(batch, mapping, material.image);
  const MixedTexels texels(material.image, batch, mapping.isSky);
  if (mode == LightMode::Both) return shade(pixels, batch, material, settings, texels);
  shade(pixels, batch, texels, [](std::size_t) { return sameChannels(1); });
}

void paintBatch(Rgb* pixels, RowBatch& batch, const SpanMapping& mapping, const Material& material,
                const DrawSettings& settings, LightMode mode) {
  if (mode != LightMode::None && material.hasUnevenLight())
    findLightPlaces(batch, mapping, material.lightmap->rect);
  if (mode == LightMode::Only)
    return shade(pixels, batch, material, settings, [](std::size_t) { return sameChannels(255); });
  if (settings.textureFilter == TextureFilter::Nearest)
    return paintNearest(pixels, batch, mapping, material, settings, mode);
  paintMixed(pixels, batch, mapping, material, settings, mode);
}

void count(const Span& span, const Material& material, PaintStats& stats) {
  const SurfaceKind kind = material.surface.kind;
  if (isSlope(kind) || isSidewall(kind)) ++stats.slopeSpans;
  if (!material.hasUnevenLight()) return;
  ++stats.lightmapSpans;
  if (material.lightmap->channels == 3) ++stats.coloredSpans;
  stats.lightmapPixels += static_cast<std::size_t>(span.rowEnd - span.rowBegin);
}

}  // namespace

void SpanPainter::paint(const Span& span, LightMode mode, Strip& strip, PaintStats& stats) const {
  Material material = materialOf(span.surface);
  // Without light that differs from pixel to pixel there is no lightmap to be mapped to.
  if (mode == LightMode::None) material.lightmap = nullptr;
  if (!material.hasUnevenLight()) material.lit = nullptr;
  count(span, material, stats);
  const SpanMapping mapping = mappingOf(material, span);
  RowBatch batch;
  for (int row = span.rowBegin; row < span.rowEnd; row += static_cast<int>(RowBatch::kRows)) {
    batch.firstRow = row;
    batch.count = std::min(RowBatch::kRows, static_cast<std::size_t>(span.rowEnd - row));
    findMeasures(batch, mapping, climbs_, settings_.depthEvery);
    paintBatch(strip.at(span.column, row), batch, mapping, material, settings_, mode);
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
