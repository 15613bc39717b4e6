#pragma once

#include "level/scene.h"
#include "walk/walk_input.h"

namespace hearth {

/// The player's body: a cylinder that stands upright on its feet.
struct Walker {
  SectorId sector;        ///< contains `feet` within kPositionSlack, always
  Vec3 feet;              ///< the middle of the footprint, metres, absolute
  Vec3 velocity;          ///< metres per second
  double angle = 0;       ///< degrees, [0, 360)
  double pitch = 0;       ///< degrees upwards, -60..60
  double crouch = 0;      ///< 0 standing upright .. 1 crouching
  bool isFlying = false;  ///< without weight, but with a body
  bool isOnGround = false;

  friend bool operator==(const Walker&, const Walker&) = default;
};

/// Places the player with the eye at a point, which the sector contains. A floor above the feet
/// raises the player, and a ceiling below the head makes the player crouch. If there is no room
/// even so, the player is stuck. A player in the air starts to fall.
Walker walkerAt(const Scene& scene, SectorId sector, Vec3 eye, double angle, double pitch);

/// The walker one tick later. Depends on nothing but its arguments, to the bit.
Walker walked(const Scene& scene, const Walker& walker, const WalkInput& input);

struct Eye {
  SectorId sector;  ///< contains `point` within kPositionSlack; it can lie above a flat portal
                    ///< that the feet are below
  Vec3 point;       ///< metres, absolute
  double angle = 0;
  double pitch = 0;

  friend bool operator==(const Eye&, const Eye&) = default;
};

Eye eyeOf(const Scene& scene, const Walker& walker);

/// The eye `fraction` (0..1) of a tick after `before`. Angles turn the shorter way.
Eye eyeBetween(const Scene& scene, const Walker& before, const Walker& after, double fraction);

}  // namespace hearth
