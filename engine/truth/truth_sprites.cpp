#include "truth/truth_sprites.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "level/locate.h"
#include "math/trig.h"
#include "truth/depth.h"

namespace hearth {

namespace {

Vec2 along(double angle) {
  const SinCos turn = sinCosDegrees(angle);
  return {turn.cos, turn.sin};
}

Vec3 level3(Vec2 v) { return {v.x, v.y, 0}; }

/// The image whose direction, seen from the sprite, is nearest to the eye's; of two equally near
/// ones the one that is farther on in the turn.
const SpriteView& seenBy(const Sprite& sprite, Vec2 eye) {
  const std::vector<SpriteView>& views = sprite.frames.front();
  const double toEye = compassDegrees(eye - sprite.position.xy());
  const SpriteView* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < views.size(); ++k) {
    const double direction =
        sprite.angle + 360.0 * static_cast<double>(k) / static_cast<double>(views.size());
    const double turn = std::remainder(toEye - direction, 360);
    if (std::abs(turn) > least || (std::abs(turn) == least && turn > 0)) continue;
    best = &views[k];
    least = std::abs(turn);
  }
  return *best;
}

SurfaceKind kindOf(const Sprite& sprite) {
  if (sprite.facing == Facing::Flat) return SurfaceKind::FlatSprite;
  return sprite.facing == Facing::Angle ? SurfaceKind::FixedSprite : SurfaceKind::CameraSprite;
}

}  // namespace

Polygon TruthSprites::Picture::outline() const {
  const Vec3 bottom = view.size.x * right;
  const Vec3 left = view.size.y * up;
  return {lowerLeft, lowerLeft + bottom, lowerLeft + bottom + left, lowerLeft + left};
}

TruthSprites::TruthSprites(const Level& level, const std::vector<Image>& textures,
                           const Shot& camera)
    : textures_(textures) {
  for (const Sprite& sprite : level.sprites) {
    Picture& picture = pictures_.emplace_back(pictureOf(sprite, camera));
    picture.isIn = sectorsCrossedBy(level, sprite.sector, {picture.outline()});
  }
}

TruthSprites::Picture TruthSprites::pictureOf(const Sprite& sprite, const Shot& camera) const {
  Picture picture{&sprite, seenBy(sprite, camera.eye.xy()), {}, {}, {0, 0, 1}, {}};
  Vec2 shift{-picture.view.size.x / 2, 0};  // from the position to the lower left corner
  switch (sprite.facing) {
    case Facing::Camera:
      picture.right = level3(turned90(along(camera.angle)));
      break;
    case Facing::Angle:
      // As for one who stands before it and looks back along its angle.
      picture.right = level3(turned90(along(sprite.angle + 180)));
      break;
    case Facing::Flat:
      // As on a map whose top is towards the angle.
      picture.right = level3(along(sprite.angle + 90));
      picture.up = level3(along(sprite.angle));
      shift.y = -picture.view.size.y / 2;
      break;
  }
  shift = shift + sprite.offset;
  picture.lowerLeft = sprite.position + shift.x * picture.right + shift.y * picture.up;
  return picture;
}

std::optional<TruthHit> TruthSprites::nearest(Vec3 origin, Vec3 direction,
                                              const AirStretch& stretch) const {
  std::optional<TruthHit> best;
  for (const Picture& picture : pictures_) {
    if (!picture.isIn[stretch.sector.index()]) continue;
    const std::optional<TruthHit> hit = meet(picture, origin, direction);
    if (!hit || !isIn(stretch, hit->t)) continue;
    if (!best || hides(hit->t, best->t)) best = hit;
  }
  return best;
}

/// None at a hole, too.
std::optional<TruthHit> TruthSprites::meet(const Picture& picture, Vec3 origin,
                                           Vec3 direction) const {
  const Vec3 normal = cross(picture.right, picture.up);
  const double speed = dot(normal, direction);
  if (speed == 0) return std::nullopt;  // seen edge-on
  const double t = dot(normal, picture.lowerLeft - origin) / speed;
  if (!(t > 0)) return std::nullopt;
  const Vec3 point = origin + t * direction;
  const double right = dot(picture.right, point - picture.lowerLeft);
  const double down = picture.view.size.y - dot(picture.up, point - picture.lowerLeft);
  if (right < 0 || right > picture.view.size.x) return std::nullopt;
  if (down < 0 || down > picture.view.size.y) return std::nullopt;

  TruthHit found;
  found.kind = kindOf(*picture.sprite);
  found.sector = picture.sprite->sector;
  found.sprite = picture.sprite->surface;
  found.point = point;
  found.normal = (speed < 0 ? 1 : -1) * normal;
  found.t = t;
  found.texture = TextureMapping{};
  found.texture->texture = picture.view.texture;
  found.texture->repeat = picture.view.size;
  found.imageMetres = {right, down};
  return isHole(found) ? std::nullopt : std::optional(found);
}

bool TruthSprites::isHole(const TruthHit& hit) const {
  const Image& image = textures_[hit.texture->texture.index()];
  const SpriteTexel texel = spriteTexelOf(hit, image);
  return image.isHole(texel.x, texel.y);
}

SpriteTexel spriteTexelOf(const TruthHit& hit, const Image& image) {
  const auto texelAt = [](double metres, double size, int texels) {
    return std::clamp(static_cast<int>(std::floor(texels * metres / size)), 0, texels - 1);
  };
  const Vec2 size = hit.texture->repeat;
  return {texelAt(hit.imageMetres.x, size.x, image.width()),
          texelAt(hit.imageMetres.y, size.y, image.height())};
}

AirPoint litPointOf(const Level& level, const Sprite& sprite) {
  const Sector& sector = level[sprite.sector];
  Vec3 point = sprite.position;
  if (sprite.facing != Facing::Flat) point.z += sprite.frames.front().front().size.y / 2;
  point.z = std::min(point.z, sector.authoredTop(point.xy()));
  point.z = std::max(point.z, sector.authoredBottom(point.xy()));
  return {nudgedInside(level, sector, point), sprite.sector};
}

}  // namespace hearth
