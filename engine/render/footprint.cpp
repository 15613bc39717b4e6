#include "render/footprint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/face_mapping.h"

namespace hearth {

namespace {

/// Of an image that is repeated, per unit of area.
double density(const TextureMapping& texture, const Texture& image) {
  return std::abs(image.width() / texture.repeat.x * (image.height() / texture.repeat.y));
}

// Areas that a pixel covers, w metres wide and high 1 m before the eye. To the next column a ray
// turns by w to the right, to the next row it climbs w less per metre of depth.

/// Of an upright surface, d metres deep along a ray r of depth 1: to the next column w d / |r n|
/// along the wall with the normal n, to the next row w d down.
double onWall(const Segment& segment, Vec2 ray, double depth, double w) {
  const Vec2 normal = (1 / segment.length) * turned90(segment.p1 - segment.p0);
  return w * depth * w * depth / std::abs(dot(ray, normal));
}

/// Of a plane h above the eye along a ray, on the map and 1 m deep. As the slope of the view ray is
/// h / d + rise, a row further down d changes by w d^2 / h, and a column further the place by w d:
/// w^2 d^3 / h.
double onPlane(double height, double w) { return w * w / std::abs(height); }

/// Of a sky, in turns to the side by tangents of elevation. A ray of length r on the map turns by
/// w / r^2 and rises by w / r.
double onSky(Vec2 ray, double w) {
  const double length2 = dot(ray, ray);
  return w / length2 / (2 * std::numbers::pi) * (w / std::sqrt(length2));
}

double pixelArea(const Scene& scene, const Projection& projection, const Span& span,
                 const SpanMapping& mapping) {
  const double w = 1 / projection.distancePx();
  if (mapping.isPlane) return onPlane(mapping.height, w);
  const Vec2 ray = projection.rayOf(span.column + 0.5);
  if (mapping.isSky) return onSky(ray, w);
  return onWall(scene[*scene[span.surface].segment], ray, span.depth, w);
}

}  // namespace

Footprint::Footprint(const Scene& scene, const Projection& projection, const Span& span,
                     const Texture& image, const SpanMapping& mapping)
    : texels_(span.face
                  ? texelsOnFace(projection, *span.face, image, mapping.isPlane ? 1 : span.depth)
                  : pixelArea(scene, projection, span, mapping) *
                        density(scene[span.surface].mapping, image)),
      growsWithDepth_(mapping.isPlane) {}

double Footprint::texelsAt(double parameter) const {
  return growsWithDepth_ ? texels_ * parameter * parameter * parameter : texels_;
}

double texelsOnFace(const Projection& projection, const MeshFace& face, const Texture& image,
                    double depth) {
  return image.width() * (image.height() * repeatsOfPixel(projection, face)) * depth * depth *
         depth;
}

int mipLevelOf(double texels) {
  // A texel of level n is 4^n of the full size; it is nearest from 4^(n - 1/2) on.
  constexpr double kMax = 0x1p60;
  // A plane at the height of the eye has no number of texels at a depth of 0: there it is 1.
  return (std::ilogb(std::min(std::max(1.0, texels), kMax)) + 1) / 2;
}

}  // namespace hearth
