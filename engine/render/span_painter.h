#pragma once

#include <span>
#include <vector>

#include "image/image.h"
#include "level/level.h"
#include "light/bakery.h"
#include "render/camera.h"
#include "render/draw_settings.h"
#include "render/row_batch.h"
#include "render/span.h"
#include "render/strip.h"

namespace hearth {

/// What the pixels of a surface are made from.
struct Material {
  const Surface& surface;
  const Image& image;
  const Lightmap* lightmap;  ///< null where no light reaches the surface
  const LitSurface* lit;     ///< null for sky
  double sectorLight;        ///< 0..1; sky is bright by itself

  /// Whether light differs from pixel to pixel.
  bool hasUnevenLight() const { return lightmap && !lightmap->isEven(); }
};

/// The second phase of a frame: gives the pixels of spans their colours. Several threads can paint
/// with one painter, as no two spans share a pixel.
class SpanPainter {
 public:
  /// All must outlive the painter. `climbs` are Projection::climbOf the centres of all rows.
  SpanPainter(const Level& level, const std::vector<Image>& textures, const BakedLight& light,
              const DrawSettings& settings, const Projection& projection,
              std::span<const double> climbs)
      : level_(level),
        textures_(textures),
        light_(light),
        settings_(settings),
        projection_(projection),
        climbs_(climbs) {}

  /// Adds to `stats` what it did.
  void paint(const Span& span, LightMode mode, Strip& strip, PaintStats& stats) const;

  Material materialOf(SurfaceId id) const;
  SpanMapping mappingOf(const Material& material, const Span& span) const {
    return hearth::mappingOf(level_, projection_, span, material.image, material.lit);
  }

 private:
  double sectorLightOn(const Surface& surface) const;

  const Level& level_;
  const std::vector<Image>& textures_;
  const BakedLight& light_;
  const DrawSettings& settings_;
  const Projection& projection_;
  std::span<const double> climbs_;
};

}  // namespace hearth
