#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "image/image.h"
#include "level/level.h"
#include "light/bakery.h"
#include "math/planted_bug.h"
#include "math/trig.h"
#include "math/whole.h"
#include "render/camera.h"
#include "render/span.h"

namespace hearth {

/// What a pixel shows of a surface.
struct Fragment {
  int row;
  double depth;  ///< metres along the view direction; infinite for sky
  double u;      ///< texel coordinates in the image, not yet repeated
  double v;
  double s;  ///< texel coordinates in the lightmap
  double t;
};

/// Index of the texel that texel coordinate `x` falls into, of an image that repeats every `size`.
inline int repeated(double x, int size) {
  if (planted(PlantedBug::TruncatingRepeat))
    return static_cast<int>(std::abs(std::fmod(x, static_cast<double>(size))));
  const std::int64_t texel = wholeBelow(x);
  if ((size & (size - 1)) == 0) return static_cast<int>(texel & (size - 1));
  const auto rest = static_cast<int>(texel % size);
  return rest < 0 ? rest + size : rest;
}

/// Half up.
inline std::uint8_t rounded(double level) {
  return static_cast<std::uint8_t>(level + (planted(PlantedBug::RoundingTruncates) ? 0 : 0.5));
}

/// Everything about a surface that spans of it share.
class SurfaceShading {
 public:
  SurfaceShading(const Level& level, const Image& image, const LitSurface* lit, SurfaceId id)
      : level_(level), surface_(level[id]), image_(image), lit_(lit) {}

  /// Calls `shade(Fragment)` for each row of the span.
  template <typename Shade>
  void forEachFragment(Projection projection, Span span, Shade&& shade) const {
    if (isSky(surface_.kind)) return sky(projection, span, shade);
    if (surface_.segment) return upright(projection, span, shade);
    plane(projection, span, shade);
  }

 private:
  template <typename Shade>
  void upright(const Projection& projection, const Span& span, Shade&& shade) const {
    const TextureMapping& mapping = surface_.mapping;
    const Segment& segment = level_[*surface_.segment];
    Fragment f{};
    f.depth = span.depth;
    const double along = planted(PlantedBug::AlongIgnored) ? 0 : mapping.along;
    f.u = image_.width() * (span.s + along) / mapping.repeat.x - mapping.offsetTexels.x;
    const Vec2 at = lerp(segment.p0, segment.p1, span.share);
    if (lit_) f.s = lit_->grid.toTexels({at.x, at.y, 0}).x;
    const double vPerMetre = image_.height() / mapping.repeat.y;
    const double texelsPerMetre = lit_ ? 1 / lit_->grid.texel : 0;
    const double eyeZ = projection.eye().z;
    for (f.row = span.rowBegin; f.row < span.rowEnd; ++f.row) {
      const double z = eyeZ + projection.climbOf(f.row + 0.5) * span.depth;
      f.v = (span.zRef - z) * vPerMetre - mapping.offsetTexels.y;
      f.t = z * texelsPerMetre;
      shade(f);
    }
  }

  /// Flats and slopes: planes z = a + b * depth over the column's ray.
  template <typename Shade>
  void plane(const Projection& projection, const Span& span, Shade&& shade) const {
    const TextureMapping& mapping = surface_.mapping;
    const Vec2 eye = projection.eye().xy();
    const Vec2 ray = projection.rayOf(span.column + 0.5);
    const auto [zAtEye, rise, origin] = planeOver(eye, ray);
    const double a = zAtEye - projection.eye().z;
    const LightOverRay light = lightOver(eye, ray, zAtEye, rise);
    const double uPerMetre = image_.width() / mapping.repeat.x;
    const double vPerMetre = image_.height() / mapping.repeat.y;
    Fragment f{};
    for (f.row = span.rowBegin; f.row < span.rowEnd; ++f.row) {
      const double depth = a / (projection.climbOf(f.row + 0.5) - rise);
      // Rounding at the horizon and at the far edge cannot leave the sector.
      f.depth = depth >= 0 && depth < span.depth ? depth : span.depth;
      const Vec2 p = eye + f.depth * ray;
      f.u = (p.x - origin.x) * uPerMetre - mapping.offsetTexels.x;
      f.v = (p.y - origin.y) * vPerMetre - mapping.offsetTexels.y;
      f.s = light.atEye.x + f.depth * light.perMetre.x;
      f.t = light.atEye.y + f.depth * light.perMetre.y;
      if (planted(PlantedBug::FlatsUnfiltered))
        f.s = std::floor(f.s) + 0.5, f.t = std::floor(f.t) + 0.5;
      shade(f);
    }
  }

  struct PlaneOverRay {
    double zAtEye;  ///< the plane's height above the eye's place on the map
    double rise;    ///< per metre of depth
    Vec2 textureOrigin;
  };

  PlaneOverRay planeOver(Vec2 eye, Vec2 ray) const {
    const Sector& sector = level_[surface_.sector];
    const Flat& flat = isOverhead(surface_.kind) ? sector.ceiling : sector.floor;
    const Vec2 flatOrigin = planted(PlantedBug::RelativeFlatIgnored) ? Vec2{} : flat.textureOrigin;
    if (!isSlope(surface_.kind)) return {flat.z, 0, flatOrigin};
    const Slope& slope =
        surface_.kind == SurfaceKind::SlopeFloor ? *sector.floorSlope : *sector.ceilingSlope;
    return {slope.zAt(eye), dot(slope.gradient, ray), flat.textureOrigin};
  }

  /// Texel coordinates in the lightmap along the ray, on the plane above or below it.
  struct LightOverRay {
    Vec2 atEye;
    Vec2 perMetre;  ///< of depth
  };

  LightOverRay lightOver(Vec2 eye, Vec2 ray, double zAtEye, double rise) const {
    if (!lit_) return {};
    const TexelGrid& grid = lit_->grid;
    const Vec3 way{ray.x, ray.y, rise};
    return {grid.toTexels({eye.x, eye.y, zAtEye}),
            {dot(way, grid.axisS) / grid.texel, dot(way, grid.axisT) / grid.texel}};
  }

  template <typename Shade>
  void sky(const Projection& projection, const Span& span, Shade&& shade) const {
    const TextureMapping& mapping = surface_.mapping;
    const Vec2 ray =
        projection.rayOf(planted(PlantedBug::SkyByScreenColumn) ? 0 : span.column + 0.5);
    const bool below =
        surface_.kind == SurfaceKind::SkyFloor || surface_.kind == SurfaceKind::SkyLowerStep;
    const double tangentPerClimb = (below ? -1 : 1) / length(ray);
    Fragment f{};
    f.depth = std::numeric_limits<double>::infinity();
    f.u = image_.width() * (compassDegrees(ray) / 360) / mapping.repeat.x - mapping.offsetTexels.x;
    for (f.row = span.rowBegin; f.row < span.rowEnd; ++f.row) {
      const double tangent = projection.climbOf(f.row + 0.5) * tangentPerClimb;
      const double v = image_.height() * (1 - tangent / mapping.repeat.y) - mapping.offsetTexels.y;
      f.v = std::clamp(v, 0.5, image_.height() - 0.5);  // beyond the image its edge rows go on
      shade(f);
    }
  }

  const Level& level_;
  const Surface& surface_;
  const Image& image_;
  const LitSurface* lit_;
};

/// The shares of a texture's red, green and blue that show: min(1, lightmap/255 + sector light).
struct LightShares {
  double r;
  double g;
  double b;
};

[[gnu::always_inline]] inline LightShares lightShares(
    const std::optional<Lightmap::Sampler>& lightmap, double sectorLight, const Fragment& f) {
  const auto shareOf = [&](double level) { return std::min(1.0, level / 255 + sectorLight); };
  if (!lightmap) return {shareOf(0), shareOf(0), shareOf(0)};
  const Lightmap::Place place = lightmap->at(f.s, f.t);
  const double first = shareOf(place.level(0));
  if (lightmap->channels() == 1) return {first, first, first};
  const double second = shareOf(place.level(1));
  return {first, second, planted(PlantedBug::ChannelLost) ? second : shareOf(place.level(2))};
}

/// Each channel rounded half up, once.
inline Rgb shaded(double r, double g, double b, LightShares light) {
  return {rounded(r * light.r), rounded(g * light.g), rounded(b * light.b)};
}

}  // namespace hearth
