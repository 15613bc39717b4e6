#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/bakery.h"
#include "math/vec.h"
#include "render/camera.h"
#include "render/draw_settings.h"
#include "render/frame_stats.h"
#include "render/glow.h"
#include "render/group_mapping.h"
#include "render/pixel_block.h"
#include "render/pixel_kernels.h"
#include "render/span_groups.h"
#include "render/strip.h"
#include "render/texture.h"

namespace hearth {

/// The data from which the pixels of a surface are computed.
struct Material {
  const Surface& surface;
  const MipMap& texture;
  const Lightmap* lightmap;  ///< null where no light reaches the surface
  LitPlaces lit;             ///< nowhere on skies and sprites
  Vec3 evenLight;            ///< of the sector, and what the texture shines with: fractions of
                             ///< red, green, blue, 0..1; sky and some sprites have all of it

  const Texture& image() const { return texture.full(); }
  /// Whether light differs from pixel to pixel.
  bool hasVaryingLight() const { return lightmap && !lightmap->isUniform(); }

  /// What counts of it in a picture of this mode. Without light that differs from pixel to pixel
  /// there is no lightmap to be mapped to.
  Material shownIn(LightMode mode) const {
    const bool isLit = mode != LightMode::None;
    return {surface, texture, isLit ? lightmap : nullptr,
            isLit && hasVaryingLight() ? lit : LitPlaces{}, isLit ? evenLight : Vec3{1, 1, 1}};
  }
};

/// The second phase of a frame: gives the pixels of spans their colours. Several threads can paint
/// with one painter, each its own strips.
class SpanPainter {
 public:
  /// All must outlive the painter. `raySlopes` are Projection::raySlopeAt the centres of all rows,
  /// and of PixelBlock::kSpareRows below the picture.
  SpanPainter(const Scene& scene, const std::vector<MipMap>& textures, const BakedLight& light,
              const Glow& glow, const DrawSettings& settings, const Projection& projection,
              std::span<const double> raySlopes)
      : scene_(scene),
        textures_(textures),
        light_(light),
        glow_(glow),
        settings_(settings),
        projection_(projection),
        raySlopes_(raySlopes) {}

  // Both work in `block`, and add their work to `stats`.
  void paint(const SpanGroup& group, LightMode mode, PixelBlock& block, Strip& strip,
             PaintStats& stats) const;
  void paint(const FaceGroup& group, LightMode mode, PixelBlock& block, Strip& strip,
             PaintStats& stats) const;

  /// Of a SpanGroup or a Span.
  template <typename Spans>
  Material materialOf(const Spans& spans) const {
    return materialOf(spans.surface, textureOf(spans.surface, spans.view, spans.face));
  }
  SpanMapping mappingOf(const Material& material, const Span& span) const {
    return hearth::mappingOf(scene_, projection_, span, &material.image(), material.lit);
  }

 private:
  Material materialOf(SurfaceId id, TextureId texture) const;
  TextureId textureOf(SurfaceId id, const SpriteView* view, const MeshFace* face) const;
  LitPlaces litPlacesOf(SurfaceId id) const;
  Vec3 evenLightOn(SurfaceId id, TextureId texture) const;
  /// What the face of a span shines with.
  Vec3 glowOf(const FaceSpan& span) const {
    return glow_.of(SurfaceKind::Mesh, span.front->texture);
  }
  /// Paints those spans that are alike in what they shine with.
  void paintAlike(const FaceGroup& group, const FaceSpan& first, LightMode mode, PixelBlock& block,
                  Strip& strip) const;
  void colorFace(const FaceSpan& span, int column, bool areMixed, PixelBlock& block) const;
  void lightFace(const FaceSpan& span, int column, const Material& material,
                 PixelBlock& block) const;
  const Texture& imageOf(const FaceSpan& span) const;
  /// Calls `use()` for the rows of a group, as many at a time as fit in a block. `use` may lower
  /// block.rows; the next block begins after those that are left.
  template <typename Group, typename Use>
  void forEachBlock(const Group& group, PixelBlock& block, Use&& use) const {
    for (int row = group.rowBegin; row < group.rowEnd; row += block.rows) {
      block.firstRow = row;
      block.rows = std::min(PixelBlock::kRows, group.rowEnd - row);
      block.raySlopes = &raySlopes_[static_cast<std::size_t>(row)];
      use();
    }
  }
  static void count(const Material& material, std::size_t spans, std::size_t pixels,
                    PaintStats& stats);
  /// Of the texels and the light of a block's pixels; `mapping` is on the image of `texels`.
  void findPlaces(const GroupTexels& texels, const GroupLight& light, const GroupMapping& mapping,
                  PixelBlock& block) const;
  bool findTexelsInFixedPoint(const GroupTexels& texels, const GroupMapping& mapping,
                              PixelBlock& block) const;
  bool findLightInFixedPoint(const GroupLight& light, const GroupMapping& mapping,
                             PixelBlock& block) const;

  Scene scene_;
  const std::vector<MipMap>& textures_;
  const BakedLight& light_;
  const Glow& glow_;
  const DrawSettings& settings_;
  const Projection& projection_;
  std::span<const double> raySlopes_;
  const PixelKernels& kernels_ = pixelKernels();
};

}  // namespace hearth
