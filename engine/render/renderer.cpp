#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "level/locate.h"
#include "light/parallel.h"
#include "math/planted_bug.h"
#include "render/shading.h"
#include "render/visibility.h"

namespace hearth {

namespace {

/// So that no thread has to wait long for one with larger spans.
constexpr std::size_t kPartsPerThread = 4;

/// The second phase of a frame: draws the spans with the pixels that a shader makes.
class SpanPainter {
 public:
  SpanPainter(const Level& level, const std::vector<Image>& textures, const BakedLight& light,
              const Projection& projection, Frame& frame)
      : level_(level), textures_(textures), light_(light), projection_(projection), frame_(frame) {}

  /// What the pixels of one span are made from.
  struct Material {
    const Surface& surface;
    const Image& image;
    std::optional<Lightmap::Sampler> lightmap;  ///< none where no light reaches the surface
    const LitSurface* lit;                      ///< null for sky
    double sectorLight;
  };

  /// Many threads can paint at once: no two spans share a pixel.
  template <typename Pixel>
  void paint(std::span<const Span> spans, int threads, Pixel&& pixel) {
    if (threads == 1) return paint(spans, pixel);
    const std::size_t parts = kPartsPerThread * static_cast<std::size_t>(threads);
    parallelFor(parts, threads, [&](std::size_t part) {
      const std::size_t begin = part * spans.size() / parts;
      paint(spans.subspan(begin, (part + 1) * spans.size() / parts - begin), pixel);
    });
  }

  /// `pixel(material, span, fragment, before)` gives a pixel's colour.
  template <typename Pixel>
  void paint(std::span<const Span> spans, Pixel&& pixel) {
    for (const Span& span : spans) {
      const Material material = materialOf(span.surface);
      const SurfaceShading shading(level_, material.image, material.lit, span.surface);
      Rgb* column = frame_.column(span.column);
      shading.forEachFragment(projection_, span, [&](const Fragment& f) {
        column[f.row] = pixel(material, span, f, column[f.row]);
      });
    }
  }

 private:
  double sectorLightOn(const Surface& surface) const {
    const bool step =
        surface.kind == SurfaceKind::LowerStep || surface.kind == SurfaceKind::UpperStep;
    return planted(PlantedBug::SectorLightForgottenOnSteps) && step ? 0
                                                                    : level_[surface.sector].light;
  }

  Material materialOf(SurfaceId id) const {
    const Surface& surface = level_[id];
    const auto& lit = light_.surfaces[id.index()];
    Material material{surface, textures_[surface.mapping.texture.index()], std::nullopt,
                      lit ? &*lit : nullptr, sectorLightOn(surface)};
    if (const auto& lightmap = light_.lightmaps[id.index()]) material.lightmap.emplace(*lightmap);
    return material;
  }

  const Level& level_;
  const std::vector<Image>& textures_;
  const BakedLight& light_;
  const Projection& projection_;
  Frame& frame_;
};

using Material = SpanPainter::Material;

/// Inlined by force, as are the functions below that every pixel calls: a call costs as much as
/// they do.
[[gnu::always_inline]] inline Rgb texel(const Image& image, const Fragment& f) {
  return image.at(repeated(f.u, image.width()), repeated(f.v, image.height()));
}

Rgb texturedPixel(const Material& material, const Span&, const Fragment& f, Rgb) {
  return texel(material.image, f);
}

[[gnu::always_inline]] inline Rgb litPixel(const Material& material, const Span&, const Fragment& f,
                                           Rgb) {
  const Rgb color = texel(material.image, f);
  if (isSky(material.surface.kind)) return color;
  return shaded(color.r, color.g, color.b, lightShares(material.lightmap, material.sectorLight, f));
}

Rgb lightPixel(const Material& material, const Span&, const Fragment& f, Rgb) {
  if (isSky(material.surface.kind)) return {255, 255, 255};
  return shaded(255, 255, 255, lightShares(material.lightmap, material.sectorLight, f));
}

/// A colour that differs clearly between neighbouring indices.
Rgb indexColor(std::size_t index) {
  const std::uint32_t mixed = (static_cast<std::uint32_t>(index) + 1) * 2654435761U;
  return {static_cast<std::uint8_t>(64 + (mixed >> 8) % 192),
          static_cast<std::uint8_t>(64 + (mixed >> 16) % 192),
          static_cast<std::uint8_t>(64 + (mixed >> 24) % 192)};
}

Rgb gray(double level) {
  const std::uint8_t value = rounded(std::clamp(level, 0.0, 255.0));
  return {value, value, value};
}

Rgb normalColor(const LitSurface* lit) {
  const Vec3 n = lit ? lit->normal : Vec3{};
  return {rounded(127.5 * (n.x + 1)), rounded(127.5 * (n.y + 1)), rounded(127.5 * (n.z + 1))};
}

Rgb uvColor(const Material& material, const Fragment& f) {
  const auto share = [](double x, int size) {
    return static_cast<std::uint8_t>(255 * (x / size - std::floor(x / size)));
  };
  return {share(f.u, material.image.width()), share(f.v, material.image.height()), 0};
}

Rgb channelPixel(Channel channel, const Material& material, const Span& span, const Fragment& f,
                 Rgb before) {
  switch (channel) {
    case Channel::Sector:
      return indexColor(material.surface.sector.index());
    case Channel::Surface:
      return indexColor(span.surface.index());
    case Channel::Depth:
      return gray(255 / (1 + f.depth));
    case Channel::Uv:
      return uvColor(material, f);
    case Channel::Normal:
      return normalColor(material.lit);
    case Channel::Light:
      return shaded(255, 255, 255, lightShares(material.lightmap, 0, f));
    case Channel::Overdraw:
      return before == kHole ? Rgb{0, 160, 0} : Rgb{255, 0, 0};
  }
  return kHole;
}

}  // namespace

Projection projectionFor(const Level& level, const Camera& camera) {
  return Projection(camera, nudgedInside(level, level[camera.sector], camera.eye));
}

void Renderer::draw(const Camera& camera, LightMode mode, FrameScratch& scratch, Image& picture,
                    int threads) const {
  const Projection projection = projectionFor(level_, camera);
  const std::span<const Span> spans =
      findVisibleSpans(level_, camera, projection, scratch.visibility).spans;
  scratch.frame.clear(camera.width, camera.height, kHole);
  SpanPainter painter(level_, textures_, light_, projection, scratch.frame);
  switch (mode) {
    case LightMode::Both:
      painter.paint(spans, threads, [](auto&&... of) { return litPixel(of...); });
      break;
    case LightMode::None:
      painter.paint(spans, threads, [](auto&&... of) { return texturedPixel(of...); });
      break;
    case LightMode::Only:
      painter.paint(spans, threads, [](auto&&... of) { return lightPixel(of...); });
      break;
  }
  scratch.frame.copyTo(picture);
}

Image Renderer::draw(const Camera& camera, LightMode mode) const {
  FrameScratch scratch;
  Image picture;
  draw(camera, mode, scratch, picture);
  return picture;
}

Image Renderer::draw(const Camera& camera, Channel channel) const {
  FrameScratch scratch;
  const Projection projection = projectionFor(level_, camera);
  scratch.frame.clear(camera.width, camera.height, kHole);
  SpanPainter(level_, textures_, light_, projection, scratch.frame)
      .paint(findVisibleSpans(level_, camera, projection, scratch.visibility).spans,
             [channel](const Material& material, const Span& span, const Fragment& f, Rgb before) {
               return channelPixel(channel, material, span, f, before);
             });
  Image picture;
  scratch.frame.copyTo(picture);
  return picture;
}

}  // namespace hearth
