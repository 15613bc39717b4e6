#include "viewer/inspect/sprite_at.h"

#include <algorithm>

#include "level/locate.h"
#include "truth/trace.h"

namespace hearth {

namespace {

/// Metres before an image that the way to it ends: it may lie on a floor.
constexpr double kBefore = 1e-4;

Vec3 crossed(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

bool isHole(const Texture& image, double across, double down) {
  const auto texel = [](double share, int count) {
    return std::clamp(static_cast<int>(share * count), 0, count - 1);
  };
  const int column = texel(across, image.width());
  return (image.texels()[column * image.height() + texel(down, image.height())] & kHoleBit) != 0;
}

/// Where the look meets the image, through walls or not.
std::optional<SpriteHit> meet(const Scene& scene, const DrawnTextures& textures,
                              const SpriteLook& look, std::size_t index) {
  const Sprite& sprite = scene.level().sprites[index];
  const SpriteView& view = viewOf(sprite, look.eye.xy(), 0);
  const SpriteRect rect = rectOf(sprite, view, look.pictureRight);
  const Vec3 normal = crossed(rect.right, rect.up);
  const double approach = dot(look.direction, normal);
  if (approach == 0) return std::nullopt;
  const double t = dot(rect.corner - look.eye, normal) / approach;
  if (!(t > 0)) return std::nullopt;
  const Vec3 inImage = look.eye + t * look.direction - rect.corner;
  const double across = dot(inImage, rect.right) / dot(rect.right, rect.right);
  const double up = dot(inImage, rect.up) / dot(rect.up, rect.up);
  if (!(across >= 0 && across < 1 && up >= 0 && up < 1)) return std::nullopt;
  if (isHole((*textures)[view.texture.index()].full(), across, 1 - up)) return std::nullopt;
  return SpriteHit{index, view.texture, t};
}

bool isInItsAir(const Scene& scene, const SpriteLook& look, const SpriteHit& hit) {
  const Sprite& sprite = scene.level().sprites[hit.sprite];
  const double t = hit.t - std::min(kBefore / length(look.direction), hit.t / 2);
  const Vec3 seen = look.eye + t * look.direction;
  const auto sector = sectorAt(scene.level(), look.sector, look.eye, seen);
  if (!sector) return false;
  const Vec3 home = nudgedInside(scene, scene[sprite.sector], sprite.position);
  const Vec3 from = nudgedInside(scene, scene[*sector], seen);
  return from == home || sectorAt(scene.level(), *sector, from, home) == sprite.sector;
}

}  // namespace

std::optional<SpriteHit> spriteAt(const Scene& scene, const DrawnTextures& textures,
                                  const SpriteLook& look, double tEnd) {
  std::optional<SpriteHit> nearest;
  double best = tEnd + kBefore / length(look.direction);
  for (std::size_t i = 0; i < scene.level().sprites.size(); ++i) {
    const auto hit = meet(scene, textures, look, i);
    // Of two at one depth the later hides the earlier.
    if (!hit || hit->t > best || !isInItsAir(scene, look, *hit)) continue;
    nearest = hit;
    best = hit->t;
  }
  return nearest;
}

}  // namespace hearth
