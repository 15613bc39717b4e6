#include "level/sprite.h"

#include <algorithm>
#include <cmath>

#include "level/locate.h"
#include "level/scene.h"
#include "math/trig.h"

namespace hearth {

namespace {

/// `x` modulo `count`, at least 0.
std::size_t modulo(double x, std::size_t count) {
  const auto size = static_cast<double>(count);
  const double rest = x - size * std::floor(x / size);
  return std::min(static_cast<std::size_t>(rest), count - 1);
}

Vec2 directionOf(double angle) {
  const SinCos turned = sinCosDegrees(angle);
  return {turned.cos, turned.sin};
}

Vec3 level3(Vec2 v) { return {v.x, v.y, 0}; }

}  // namespace

const SpriteView& viewOf(const Sprite& sprite, Vec2 eye, double seconds) {
  const auto& views =
      sprite.frames.size() == 1
          ? sprite.frames.front()
          : sprite
                .frames[modulo(std::floor(seconds * sprite.framesPerSecond), sprite.frames.size())];
  if (views.size() == 1) return views.front();
  const double turn = (compassDegrees(eye - sprite.position.xy()) - sprite.angle) / 360;
  return views[modulo(std::floor(turn * static_cast<double>(views.size()) + 0.5), views.size())];
}

SpriteRect rectOf(const Sprite& sprite, const SpriteView& view, Vec2 pictureRight) {
  Vec3 right = level3(pictureRight);
  Vec3 up = {0, 0, 1};
  double below = 0;  // how much of the image is below the position
  if (sprite.facing == Facing::Angle) {
    // An eye that looks at the front looks against it, and has its left to the right.
    right = level3(-1 * turned90(directionOf(sprite.angle)));
  } else if (sprite.facing == Facing::Flat) {
    up = level3(directionOf(sprite.angle));
    right = level3(turned90(up.xy()));
    below = view.size.y / 2;
  }
  return {sprite.position + (sprite.offset.x - view.size.x / 2) * right +
              (sprite.offset.y - below) * up,
          view.size.x * right, view.size.y * up};
}

Vec3 lightPointOf(const Scene& scene, const Sprite& sprite) {
  const Sector& sector = scene[sprite.sector];
  Vec3 point = sprite.position;
  if (sprite.facing != Facing::Flat) point.z += sprite.frames.front().front().size.y / 2;
  const double bottom = scene.airBottom(sector, point.xy());
  point.z = std::clamp(point.z, bottom, std::max(bottom, scene.airTop(sector, point.xy())));
  return nudgedInside(scene, sector, point);
}

}  // namespace hearth
