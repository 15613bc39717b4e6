#include "render/span_mapping.h"

#include <limits>

#include "math/trig.h"

namespace hearth {

namespace {

/// The same texel all along the span.
ImageAxis constant(double texel) { return {.place = {texel, 0}}; }

/// Of a lightmap, if any.
struct LightAxes {
  Affine s{};
  Affine t{};
};

LightAxes uprightLightAxes(const Scene& scene, const Projection& projection, const Span& span,
                           const LitSurface* lit) {
  if (!lit) return {};
  const Segment& segment = scene[*scene[span.surface].segment];
  const Vec2 at = lerp(segment.p0, segment.p1, span.fraction);
  const TexelGrid& grid = lit->grid;
  return {.s = {grid.toTexels({at.x, at.y, 0}).x, 0},
          .t = {projection.eye().z / grid.texel, span.depth / grid.texel}};
}

SpanMapping uprightMapping(const Scene& scene, const Projection& projection, const Span& span,
                           const Texture& image, const LitSurface* lit) {
  const TextureMapping& texture = scene[span.surface].mapping;
  const LightAxes light = uprightLightAxes(scene, projection, span, lit);
  return {.depth = span.depth,
          .u = constant(image.width() * (span.s + texture.along) / texture.repeat.x -
                        texture.offsetTexels.x),
          .v = {{projection.eye().z, span.depth},
                span.zRef,
                -image.height() / texture.repeat.y,
                texture.offsetTexels.y},
          .s = light.s,
          .t = light.t};
}

struct PlaneOverRay {
  double zAtEye;  ///< the plane's height above the eye's place on the map
  double rise;    ///< per metre of depth
  Vec2 textureOrigin;
};

PlaneOverRay planeOver(const Scene& scene, SurfaceId id, Vec2 eye, Vec2 ray) {
  const Surface& surface = scene[id];
  const Sector& sector = scene[surface.sector];
  const Flat& flat = facesDown(surface.kind) ? sector.ceiling : sector.floor;
  if (!isSlope(surface.kind)) return {scene.geometryOf(id).zBottom, 0, flat.textureOrigin};
  const Slope& slope =
      surface.kind == SurfaceKind::SlopeFloor ? *sector.floorSlope : *sector.ceilingSlope;
  return {slope.zAt(eye), dot(slope.gradient, ray), flat.textureOrigin};
}

LightAxes planeLightAxes(const PlaneOverRay& plane, Vec3 eye, Vec2 ray, const LitSurface* lit) {
  if (!lit) return {};
  const TexelGrid& grid = lit->grid;
  const Vec2 atEye = grid.toTexels({eye.x, eye.y, plane.zAtEye});
  const Vec3 direction{ray.x, ray.y, plane.rise};
  return {.s = {atEye.x, dot(direction, grid.axisS) / grid.texel},
          .t = {atEye.y, dot(direction, grid.axisT) / grid.texel}};
}

SpanMapping planeMapping(const Scene& scene, const Projection& projection, const Span& span,
                         const Texture& image, const LitSurface* lit) {
  const Surface& surface = scene[span.surface];
  const TextureMapping& texture = surface.mapping;
  const Vec3 eye = projection.eye();
  const Vec2 ray = projection.rayOf(span.column + 0.5);
  const PlaneOverRay plane = planeOver(scene, span.surface, eye.xy(), ray);
  const LightAxes light = planeLightAxes(plane, eye, ray, lit);
  const Vec2 origin = plane.textureOrigin;
  return {
      .isPlane = true,
      .height = plane.zAtEye - eye.z,
      .rise = plane.rise,
      .depth = span.depth,
      .u = {{eye.x, ray.x}, origin.x, image.width() / texture.repeat.x, texture.offsetTexels.x},
      .v = {{eye.y, ray.y}, origin.y, image.height() / texture.repeat.y, texture.offsetTexels.y},
      .s = light.s,
      .t = light.t};
}

SpanMapping skyMapping(const Scene& scene, const Projection& projection, const Span& span,
                       const Texture& image) {
  const Surface& surface = scene[span.surface];
  const TextureMapping& texture = surface.mapping;
  const Vec2 ray = projection.rayOf(span.column + 0.5);
  const bool below =
      surface.kind == SurfaceKind::SkyFloor || surface.kind == SurfaceKind::SkyLowerStep;
  const double tangentPerRaySlope = (below ? -1 : 1) / length(ray);
  return {.isSky = true,
          .depth = std::numeric_limits<double>::infinity(),
          .u = constant(image.width() * (compassDegrees(ray) / 360) / texture.repeat.x -
                        texture.offsetTexels.x),
          .v = {{0, tangentPerRaySlope},
                texture.repeat.y,
                -image.height() / texture.repeat.y,
                texture.offsetTexels.y}};
}

}  // namespace

SpanMapping onImage(SpanMapping mapping, const Texture& from, const Texture& to) {
  const auto scale = [](ImageAxis& axis, int sizeFrom, int sizeTo) {
    const double scaled = static_cast<double>(sizeTo) / sizeFrom;
    axis.texelsPerPlace *= scaled;
    axis.offset *= scaled;
  };
  scale(mapping.u, from.width(), to.width());
  scale(mapping.v, from.height(), to.height());
  return mapping;
}

SpanMapping lightMappingOf(const Scene& scene, const Projection& projection, const Span& span,
                           const LitSurface& lit) {
  const Surface& surface = scene[span.surface];
  if (surface.segment) {
    const LightAxes light = uprightLightAxes(scene, projection, span, &lit);
    return {.depth = span.depth, .s = light.s, .t = light.t};
  }
  const Vec3 eye = projection.eye();
  const Vec2 ray = projection.rayOf(span.column + 0.5);
  const PlaneOverRay plane = planeOver(scene, span.surface, eye.xy(), ray);
  const LightAxes light = planeLightAxes(plane, eye, ray, &lit);
  return {.isPlane = true,
          .height = plane.zAtEye - eye.z,
          .rise = plane.rise,
          .depth = span.depth,
          .s = light.s,
          .t = light.t};
}

SpanMapping mappingOf(const Scene& scene, const Projection& projection, const Span& span,
                      const Texture& image, const LitSurface* lit) {
  const Surface& surface = scene[span.surface];
  if (isSky(surface.kind)) return skyMapping(scene, projection, span, image);
  if (surface.segment) return uprightMapping(scene, projection, span, image, lit);
  return planeMapping(scene, projection, span, image, lit);
}

}  // namespace hearth
