#include "truth/truth_view.h"

#include <algorithm>
#include <cmath>

#include "level/locate.h"
#include "math/check.h"
#include "math/trig.h"
#include "math/wrapped.h"
#include "truth/depth.h"
#include "truth/truth_meshes.h"

namespace hearth {

namespace {

std::uint8_t rounded(double value) { return static_cast<std::uint8_t>(std::floor(value + 0.5)); }

Vec3 vectorOf(Rgb color) { return {1.0 * color.r, 1.0 * color.g, 1.0 * color.b}; }

/// The fractions that show of red, green and blue under that light, in levels.
Vec3 fractionsOf(Vec3 levels, double sectorLight) {
  const auto fraction = [&](double level) { return std::min(1.0, level / 255 + sectorLight); };
  return {fraction(levels.x), fraction(levels.y), fraction(levels.z)};
}

}  // namespace

Vec2 texelOf(const TruthHit& hit, int width, int height) {
  const TextureMapping& mapping = *hit.texture;
  return Vec2{width * hit.imageMetres.x / mapping.repeat.x,
              height * hit.imageMetres.y / mapping.repeat.y} -
         mapping.offsetTexels;
}

TruthView::TruthView(const Level& level, const std::vector<Image>& textures, const Shot& camera,
                     int ballPoints)
    : level_(level),
      textures_(textures),
      camera_(camera),
      light_(level, ballPoints),
      emission_(level),
      sprites_(level, textures, camera) {
  camera_.eye = nudgedInside(level, level[camera.sector], camera.eye);
}

/// The direction of the pixel, 1 m deep along the camera's.
Vec3 TruthView::directionTo(double i, double j) const {
  const double pixelsPerTangent = camera_.width / 2.0 / tanDegrees(camera_.fov / 2);
  const double centerRow = camera_.height / 2.0 + pixelsPerTangent * tanDegrees(camera_.pitch);
  const SinCos angle = sinCosDegrees(camera_.angle);
  const Vec2 forward{angle.cos, angle.sin};
  const Vec2 side = (i - camera_.width / 2.0) / pixelsPerTangent * turned90(forward);
  return {forward.x + side.x, forward.y + side.y, (centerRow - j) / pixelsPerTangent};
}

/// The nearest thing in a stretch of air; of two at one depth the later.
std::optional<TruthHit> TruthView::nearestThing(Vec3 direction, const AirStretch& air) const {
  const std::optional<TruthHit> sprite = sprites_.nearest(camera_.eye, direction, air);
  const std::optional<TruthHit> mesh = light_.meshes().nearest(camera_.eye, direction, air);
  if (!sprite || !mesh) return sprite ? sprite : mesh;
  const bool isMeshLater =
      level_.meshOf(*mesh->mesh).thing > level_.spriteOf(*sprite->sprite).thing;
  const TruthHit& later = isMeshLater ? *mesh : *sprite;
  const TruthHit& earlier = isMeshLater ? *sprite : *mesh;
  return hides(later.t, earlier.t) ? later : earlier;
}

TruthHit TruthView::hit(double i, double j) const {
  const Vec3 direction = directionTo(i, j);
  const TruthHit found =
      traceLook(level_, camera_.sector, camera_.eye, direction,
                [&](const AirStretch& air) { return nearestThing(direction, air); });
  CHECK(found.texture, i, j);
  return found;
}

Vec2 TruthView::texelAt(const TruthHit& hit) const {
  const Image& image = textures_[hit.texture->texture.index()];
  return texelOf(hit, image.width(), image.height());
}

Vec3 TruthView::textureColor(const TruthHit& hit) const {
  const Image& image = textures_[hit.texture->texture.index()];
  if (hit.sprite) {
    const SpriteTexel texel = spriteTexelOf(hit, image);
    return vectorOf(image.at(texel.x, texel.y));
  }
  const Vec2 texel = texelAt(hit);
  const int row = isSky(hit.kind)
                      ? static_cast<int>(std::clamp(std::floor(texel.y), 0.0, image.height() - 1.0))
                      : wrapped(texel.y, image.height());
  return vectorOf(image.at(wrapped(texel.x, image.width()), row));
}

/// The fractions of a texture's red, green and blue that show.
Vec3 TruthView::lightOn(const TruthHit& hit) const {
  if (hit.sprite) return lightOnSprite(level_.spriteOf(*hit.sprite));
  return fractionsOf(light_.at(hit) + emission_.of(hit), level_[hit.sector].light);
}

/// Its light is one of 8 bits, like a lightmap's texel.
Vec3 TruthView::lightOnSprite(const Sprite& sprite) const {
  if (sprite.isBright) return {1, 1, 1};
  const Vec3 levels = light_.at(litPointOf(level_, sprite));
  const auto stored = [](double level) { return std::floor(std::clamp(level, 0.0, 255.0) + 0.5); };
  return fractionsOf({stored(levels.x), stored(levels.y), stored(levels.z)},
                     level_[sprite.sector].light);
}

TruthPixel TruthView::pixel(double i, double j, TruthLightMode mode) const {
  const TruthHit found = hit(i, j);
  const Vec3 color = mode == TruthLightMode::Only ? Vec3{255, 255, 255} : textureColor(found);
  const bool isLit = mode != TruthLightMode::None && !isSky(found.kind);
  const Vec3 light = isLit ? lightOn(found) : Vec3{1, 1, 1};
  const Vec3 exact{color.x * light.x, color.y * light.y, color.z * light.z};
  return {{rounded(exact.x), rounded(exact.y), rounded(exact.z)}, exact, light, found};
}

bool TruthView::isClear(double i, double j, double radius) const {
  const TruthHit center = hit(i, j);
  const Vec2 texel = texelAt(center);
  const Vec2 circle[] = {{1, 0},   {-1, 0},   {0, 1},    {0, -1},
                         {.7, .7}, {-.7, .7}, {.7, -.7}, {-.7, -.7}};
  return std::ranges::all_of(circle, [&](Vec2 to) {
    const TruthHit there = hit(i + radius * to.x, j + radius * to.y);
    if (!isSameSurface(there, center) || there.subWall != center.subWall) return false;
    const Vec2 itsTexel = texelAt(there);
    return std::floor(itsTexel.x) == std::floor(texel.x) &&
           std::floor(itsTexel.y) == std::floor(texel.y);
  });
}

Image TruthView::picture(TruthLightMode mode) const {
  Image picture(camera_.width, camera_.height);
  for (int j = 0; j < camera_.height; ++j)
    for (int i = 0; i < camera_.width; ++i) picture.at(i, j) = pixel(i + 0.5, j + 0.5, mode).color;
  return picture;
}

}  // namespace hearth
