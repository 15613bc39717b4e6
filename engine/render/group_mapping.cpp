#include "render/group_mapping.h"

#include <limits>
#include <optional>
#include <variant>

#include "math/check.h"
#include "math/trig.h"
#include "render/face_mapping.h"

namespace hearth {

namespace {

/// Register by register: GCC makes of one assignment a `rep stos`, which is slow to start.
void setZero(LaneAffine& axis) {
  axis.atZero.fill(0);
  axis.per.fill(0);
}

/// The same texel all along a column.
void setConstant(LaneImageAxis& axis) {
  axis.place.per.fill(0);
  axis.origin.fill(0);
}

// --- What is upright -----------------------------------------------------------------------------

/// The columns are so many metres along the image, before it is shifted. The caller sets v.origin,
/// the height at which v is 0.
void mapUprightImage(const TextureMapping& texture, const Texture& image, double eyeZ,
                     const LaneDoubles& metresAlong, const SpanGroup& group,
                     GroupMapping& mapping) {
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane)
    mapping.u.place.atZero[lane] =
        image.width() * (metresAlong[lane] + texture.along) / texture.repeat.x -
        texture.offsetTexels.x;
  setConstant(mapping.u);
  mapping.v.place.atZero.fill(eyeZ);
  mapping.v.place.per = group.depth;
  mapping.v.texelsPerPlace = -image.height() / texture.repeat.y;
  mapping.v.offset = texture.offsetTexels.y;
}

SegmentId twinOf(const Scene& scene, const Segment& segment, SurfaceId sidewall) {
  for (const WallPiece& piece : scene.piecesOf(segment)) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    if (opening && (opening->floorSidewall == sidewall || opening->ceilingSidewall == sidewall))
      return opening->twin;
  }
  CHECK(false, sidewall);
}

/// A sidewall wears the far wall's texture, from that wall's right end as seen from inside. If no
/// height is authored for it, it hangs at the edge of its slope.
void mapWallImage(const Scene& scene, const Texture& image, double eyeZ, const SpanGroup& group,
                  GroupMapping& mapping) {
  const Surface& surface = scene[group.surface];
  const Segment& near = scene[*surface.segment];
  const bool isFar = isSidewall(surface.kind);
  const Segment& wall = isFar ? scene[twinOf(scene, near, group.surface)] : near;
  const double before = isFar ? wall.sAfter : wall.sBefore;
  LaneDoubles metresAlong;
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane)
    metresAlong[lane] = before + group.fraction[lane] * wall.length;
  mapUprightImage(surface.mapping, image, eyeZ, metresAlong, group, mapping);
  if (const std::optional<double> zRef = scene.geometryOf(group.surface).zRef) {
    mapping.v.origin.fill(*zRef);
    return;
  }
  CHECK(isFar, group.surface);
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) {
    const AirColumn edge = scene.airAt(wall, 1 - group.fraction[lane]);
    mapping.v.origin[lane] = surface.kind == SurfaceKind::FloorSidewall ? edge.zBottom : edge.zTop;
  }
}

void mapUprightLight(const Segment& segment, const TexelGrid& grid, double eyeZ,
                     const SpanGroup& group, GroupMapping& mapping) {
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) {
    const Vec2 at = lerp(segment.p0, segment.p1, group.fraction[lane]);
    mapping.s.atZero[lane] = grid.toTexels({at.x, at.y, 0}).x;
    mapping.t.per[lane] = group.depth[lane] / grid.texel;
  }
  mapping.t.atZero.fill(eyeZ / grid.texel);
  mapping.s.per.fill(0);
}

// --- Planes --------------------------------------------------------------------------------------

/// The directions of the view rays of a group's columns in plan, 1 m deep.
using LaneRays = std::array<Vec2, Strip::kColumns>;

LaneRays raysOf(const Projection& projection, const SpanGroup& group) {
  LaneRays rays;
  for (std::size_t lane = 0; lane < rays.size(); ++lane)
    rays[lane] = projection.rayOf(group.firstColumn + static_cast<int>(lane) + 0.5);
  return rays;
}

void mapPlaneImage(const TextureMapping& texture, const Texture& image, Vec2 origin, Vec2 eye,
                   const LaneRays& rays, GroupMapping& mapping) {
  for (std::size_t lane = 0; lane < rays.size(); ++lane) {
    mapping.u.place.atZero[lane] = eye.x;
    mapping.u.place.per[lane] = rays[lane].x;
    mapping.v.place.atZero[lane] = eye.y;
    mapping.v.place.per[lane] = rays[lane].y;
  }
  mapping.u.origin.fill(origin.x);
  mapping.v.origin.fill(origin.y);
  mapping.u.texelsPerPlace = image.width() / texture.repeat.x;
  mapping.v.texelsPerPlace = image.height() / texture.repeat.y;
  mapping.u.offset = texture.offsetTexels.x;
  mapping.v.offset = texture.offsetTexels.y;
}

void mapPlaneLight(const TexelGrid& grid, Vec3 belowEye, const LaneRays& rays,
                   GroupMapping& mapping) {
  const Vec2 atEye = grid.toTexels(belowEye);
  for (std::size_t lane = 0; lane < rays.size(); ++lane) {
    const Vec3 direction{rays[lane].x, rays[lane].y, mapping.rise[lane]};
    mapping.s.atZero[lane] = atEye.x;
    mapping.s.per[lane] = dot(direction, grid.axisS) / grid.texel;
    mapping.t.atZero[lane] = atEye.y;
    mapping.t.per[lane] = dot(direction, grid.axisT) / grid.texel;
  }
}

void mapPlane(const Scene& scene, const Projection& projection, const SpanGroup& group,
              const Texture* image, const LitSurface* lit, GroupMapping& mapping) {
  const Surface& surface = scene[group.surface];
  const Sector& sector = scene[surface.sector];
  const Flat& flat = facesDown(surface.kind) ? sector.ceiling : sector.floor;
  const Vec3 eye = projection.eye();
  const LaneRays rays = raysOf(projection, group);
  double zAtEye = 0;  // the plane's height above the eye's place on the map
  mapping.isPlane = true;
  mapping.isLevel = !isSlope(surface.kind);
  if (mapping.isLevel) {
    zAtEye = scene.geometryOf(group.surface).zBottom;
    mapping.rise.fill(0);
  } else {
    const Slope& slope =
        surface.kind == SurfaceKind::SlopeFloor ? *sector.floorSlope : *sector.ceilingSlope;
    zAtEye = slope.zAt(eye.xy());
    for (std::size_t lane = 0; lane < rays.size(); ++lane)
      mapping.rise[lane] = dot(slope.gradient, rays[lane]);
  }
  mapping.height = zAtEye - eye.z;
  if (image) mapPlaneImage(surface.mapping, *image, flat.textureOrigin, eye.xy(), rays, mapping);
  if (lit) mapPlaneLight(lit->grid, {eye.x, eye.y, zAtEye}, rays, mapping);
}

// --- Skies ---------------------------------------------------------------------------------------

void mapSky(const Surface& surface, const Texture& image, const LaneRays& rays,
            GroupMapping& mapping) {
  const TextureMapping& texture = surface.mapping;
  const bool below =
      surface.kind == SurfaceKind::SkyFloor || surface.kind == SurfaceKind::SkyLowerStep;
  for (std::size_t lane = 0; lane < rays.size(); ++lane) {
    mapping.u.place.atZero[lane] =
        image.width() * (compassDegrees(rays[lane]) / 360) / texture.repeat.x -
        texture.offsetTexels.x;
    mapping.v.place.per[lane] = (below ? -1 : 1) / length(rays[lane]);
  }
  setConstant(mapping.u);
  mapping.v.place.atZero.fill(0);
  mapping.v.origin.fill(texture.repeat.y);
  mapping.v.texelsPerPlace = -image.height() / texture.repeat.y;
  mapping.v.offset = texture.offsetTexels.y;
}

// --- Sprites -------------------------------------------------------------------------------------

/// How a sprite's image lies on it. Its edges are moved by so much of the image that rounding takes
/// no pixel beyond them, to the texels of the opposite edge: four times what 32 rows in fixed point
/// add up to.
TextureMapping mappingOfImage(const SpriteView& view, const Texture& image) {
  constexpr double kInset = 0x1p-26;
  TextureMapping mapping;
  mapping.texture = view.texture;
  mapping.repeat = (1 / (1 - 2 * kInset)) * view.size;
  mapping.offsetTexels = -kInset * Vec2{1.0 * image.width(), 1.0 * image.height()};
  return mapping;
}

void mapStandingSprite(const Texture& image, double eyeZ, const SpanGroup& group,
                       GroupMapping& mapping) {
  LaneDoubles metresAlong;
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane)
    metresAlong[lane] = group.fraction[lane] * group.view->size.x;
  mapUprightImage(mappingOfImage(*group.view, image), image, eyeZ, metresAlong, group, mapping);
  mapping.v.origin.fill(group.zTop);
}

/// What lies is a plane, whose image is turned.
void mapLyingSprite(const Sprite& sprite, const SpriteView& view, const Projection& projection,
                    const SpanGroup& group, const Texture* image, GroupMapping& mapping) {
  const Vec2 eye = projection.eye().xy();
  const LaneRays rays = raysOf(projection, group);
  mapping.isPlane = true;
  mapping.isLevel = true;
  mapping.rise.fill(0);
  mapping.height = sprite.position.z - projection.eye().z;
  if (!image) return;
  const SpriteRect rect = rectOf(sprite, view, {});
  const Vec2 upperLeft = rect.corner.xy() + rect.up.xy();
  const Vec2 right = unit(rect.right.xy());
  const Vec2 down = unit(-1 * rect.up.xy());
  LaneRays turned;
  for (std::size_t lane = 0; lane < rays.size(); ++lane)
    turned[lane] = {dot(rays[lane], right), dot(rays[lane], down)};
  mapPlaneImage(mappingOfImage(view, *image), *image, {dot(upperLeft, right), dot(upperLeft, down)},
                {dot(eye, right), dot(eye, down)}, turned, mapping);
}

Affine laneOf(const LaneAffine& along, std::size_t lane) {
  return {along.atZero[lane], along.per[lane]};
}

ImageAxis laneOf(const LaneImageAxis& along, std::size_t lane) {
  return {laneOf(along.place, lane), along.origin[lane], along.texelsPerPlace, along.offset};
}

}  // namespace

SpanMapping GroupMapping::of(std::size_t lane) const {
  return {.isPlane = isPlane,
          .isSky = isSky,
          .height = height,
          .rise = isPlane ? rise[lane] : 0,
          .depth = depth[lane],
          .u = laneOf(u, lane),
          .v = laneOf(v, lane),
          .s = laneOf(s, lane),
          .t = laneOf(t, lane)};
}

GroupMapping mappingOf(const Scene& scene, const Projection& projection, const SpanGroup& group,
                       const Texture* image, const LitPlaces& lit) {
  GroupMapping mapping;
  // What is not asked for is 0.
  if (!image) mapping.u = mapping.v = {};
  if (!lit) {
    setZero(mapping.s);
    setZero(mapping.t);
  }
  const Surface& surface = scene[group.surface];
  if (isSky(surface.kind)) {
    mapping.isSky = true;
    mapping.depth.fill(std::numeric_limits<double>::infinity());
    mapSky(surface, *image, raysOf(projection, group), mapping);
    return mapping;
  }
  mapping.depth = group.depth;
  if (surface.kind == SurfaceKind::Mesh) {
    mapFace(projection, group, image, placesOf(scene.level(), lit.mesh, *group.face), mapping);
    return mapping;
  }
  if (surface.kind == SurfaceKind::FlatSprite) {
    mapLyingSprite(scene.level().spriteOf(group.surface), *group.view, projection, group, image,
                   mapping);
    return mapping;
  }
  if (isSprite(surface.kind)) {
    if (image) mapStandingSprite(*image, projection.eye().z, group, mapping);
    return mapping;
  }
  if (!surface.segment) {
    mapPlane(scene, projection, group, image, lit.surface, mapping);
    return mapping;
  }
  const double eyeZ = projection.eye().z;
  if (image) mapWallImage(scene, *image, eyeZ, group, mapping);
  if (lit.surface)
    mapUprightLight(scene[*surface.segment], lit.surface->grid, eyeZ, group, mapping);
  return mapping;
}

GroupMapping onImage(GroupMapping mapping, const Texture& from, const Texture& to) {
  const auto scale = [](LaneImageAxis& axis, int sizeFrom, int sizeTo) {
    const double scaled = static_cast<double>(sizeTo) / sizeFrom;
    axis.texelsPerPlace *= scaled;
    axis.offset *= scaled;
  };
  scale(mapping.u, from.width(), to.width());
  scale(mapping.v, from.height(), to.height());
  return mapping;
}

SpanMapping mappingOf(const Scene& scene, const Projection& projection, const Span& span,
                      const Texture* image, const LitPlaces& lit) {
  const auto lane = static_cast<std::size_t>(span.column % Strip::kColumns);
  SpanGroup group;
  group.surface = span.surface;
  group.view = span.view;
  group.face = span.face;
  group.firstColumn = span.column - static_cast<int>(lane);
  group.depth.fill(span.depth);
  group.zTop = span.zTop;
  group.fraction.fill(span.fraction);
  return mappingOf(scene, projection, group, image, lit).of(lane);
}

}  // namespace hearth
