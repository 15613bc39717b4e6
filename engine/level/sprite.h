#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "level/ids.h"
#include "math/vec.h"

namespace hearth {

class Scene;

/// How the image of a sprite stands.
enum class Facing {
  Camera,  ///< upright, in a plane parallel to the picture
  Angle,   ///< upright, its front towards the sprite's angle; mirrored from behind
  Flat,    ///< lies, its top towards the sprite's angle; seen from above and below
};

/// A sprite's image as seen from one side, at one time.
struct SpriteView {
  TextureId texture;
  Vec2 size;  ///< metres, > 0
};

/// The body of a sprite that is solid to the player: a cylinder around its position.
struct SpriteBody {
  double radius = 0;  ///< metres
  double height = 0;  ///< metres, from the sprite's position up
};

/// An image that stands or lies in the air of a level. Doom calls these things, Build sprites.
struct Sprite {
  std::string name;            ///< may be empty
  Vec3 position;               ///< the middle of its lower edge; where it lies, its centre
  SectorId sector;             ///< that contains `position`
  bool standsOnFloor = false;  ///< of its sector, with which it moves
  double angle = 0;            ///< degrees
  Facing facing = Facing::Camera;
  Vec2 offset;  ///< metres by which the image is shifted, to its right and up
  /// The frames of an animation, each seen from as many sides: view k by an eye that stands at
  /// `angle` + k turns / count. Both at least one.
  std::vector<std::vector<SpriteView>> frames;
  double framesPerSecond = 0;
  bool isBright = false;  ///< shows as it is, whatever the light
  std::optional<SpriteBody> body;
  std::uint32_t thing = 0;  ///< index among the level's sprites and meshes together

  SurfaceId surface;  ///< set by `addThingSurfaces`
};

/// Whether what it shows depends on time.
inline bool isAnimated(const Sprite& sprite) { return sprite.frames.size() > 1; }

/// What a sprite shows to an eye at a time: the frame of that time, seen from the nearest side.
const SpriteView& viewOf(const Sprite& sprite, Vec2 eye, double seconds);

/// A sprite's image in space.
struct SpriteRect {
  Vec3 corner;  ///< its lower left corner, seen from the front
  Vec3 right;   ///< its lower edge
  Vec3 up;      ///< its left edge
};

/// `pictureRight` is the direction to the right of the picture, of length 1, in which a sprite that
/// faces the camera stands.
SpriteRect rectOf(const Sprite& sprite, const SpriteView& view, Vec2 pictureRight);

/// The point of air whose light a sprite takes: half its height above its position, moved into the
/// air of its sector.
Vec3 lightPointOf(const Scene& scene, const Sprite& sprite);

}  // namespace hearth
