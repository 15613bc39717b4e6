#include "walk/walker.h"

#include <algorithm>
#include <cmath>

#include "math/trig.h"
#include "walk/stand.h"

namespace hearth {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;  // s

constexpr double kWalkSpeed = 2.5;      // m/s
constexpr double kRunSpeed = 5;         // m/s
constexpr double kFlySpeed = 5;         // m/s
constexpr double kFastFlySpeed = 10;    // m/s
constexpr double kCrouchedSpeed = 0.5;  // fraction of the others

constexpr double kGravity = 9.81;    // m/s^2
constexpr double kJumpSpeed = 3.3;   // m/s: v^2 / 2g = 0.555 m high
constexpr double kFastestFall = 50;  // m/s, about that of a falling body in air

/// Fraction of the difference to the wanted speed that a tick makes up for: a hundredth is left
/// after a quarter of a second on the ground, after two seconds in the air.
constexpr double kGripOnGround = 0.25;
constexpr double kGripInAir = 1.0 / 32;

constexpr double kNoSpeed = 1e-6;  // m/s: a skin in a second

constexpr double kCrouchPerTick = 0.125;
constexpr double kMaxPitch = 60;  // degrees, what the projection takes

/// A tick's move is made in parts of at most half a radius, so that the feet follow the ground, but
/// not in more than this: nothing is passed in longer ones either.
constexpr int kMaxParts = 16;

double fractionOf(int input) {
  return std::clamp(input, -kFullSpeed, kFullSpeed) / double(kFullSpeed);
}

void turn(Walker& walker, const WalkInput& input) {
  walker.angle = wrappedDegrees(walker.angle + input.turn / 1000.0);
  walker.pitch = std::clamp(walker.pitch + input.pitch / 1000.0, -kMaxPitch, kMaxPitch);
}

/// The input in axes of the world, at most of length 1.
Vec3 wantedDirection(const Walker& walker, const WalkInput& input) {
  const double forward = fractionOf(input.forward);
  const double right = fractionOf(input.right);
  const double up = walker.isFlying ? fractionOf(input.up) : 0;
  const SinCos heading = sinCosDegrees(walker.angle);
  const Vec2 ahead{heading.cos, heading.sin};
  const Vec2 level = forward * ahead + right * turned90(ahead);
  const Vec3 wanted{level.x, level.y, up};
  const double size = length(wanted);
  return size > 1 ? (1 / size) * wanted : wanted;
}

double speedOf(const Walker& walker, const WalkInput& input) {
  if (walker.isFlying) return input.run ? kFastFlySpeed : kFlySpeed;
  return (input.run ? kRunSpeed : kWalkSpeed) * (1 - (1 - kCrouchedSpeed) * walker.crouch);
}

/// `speed` brought nearer to the one that is wanted, and at last to it.
double nearer(double speed, double wanted, double grip) {
  const double lack = wanted - speed;
  return std::abs(lack) < kNoSpeed ? wanted : speed + grip * lack;
}

void accelerate(Walker& walker, const WalkInput& input) {
  const Vec3 wanted = speedOf(walker, input) * wantedDirection(walker, input);
  const bool hasGrip = walker.isOnGround || walker.isFlying;
  const double grip = hasGrip ? kGripOnGround : kGripInAir;
  Vec3& v = walker.velocity;
  // Without input, a walker in the air keeps its speed.
  if (hasGrip || wanted != Vec3{}) {
    v.x = nearer(v.x, wanted.x, grip);
    v.y = nearer(v.y, wanted.y, grip);
  }
  if (walker.isFlying) v.z = nearer(v.z, wanted.z, grip);
}

/// Down at once; up as far as there is room.
void crouch(const Scene& scene, Walker& walker, const Stand& stand, bool wantsCrouch) {
  const double wanted =
      std::clamp(walker.crouch + (wantsCrouch ? kCrouchPerTick : -kCrouchPerTick), 0.0, 1.0);
  if (wanted > walker.crouch || stand.hasRoomFor(bodyOf(scene.level(), wanted).height))
    walker.crouch = wanted;
}

/// The walker's place, known as far up and down as a tick can rise, fall and straighten up.
std::optional<Stand> standOf(const Scene& scene, const Walker& walker, const Body& body) {
  const double fall = std::max(0.0, -walker.velocity.z) * kTick + kGravity * kTick * kTick;
  const double rise = std::max(0.0, walker.velocity.z) * kTick;
  const double bend = bodyOf(scene.level(), 0).height - body.height;
  return standAt(scene, body, walker.sector, walker.feet, walker.feet.z,
                 std::max(body.stepHeight, fall), std::max({body.stepHeight, rise, bend}));
}

/// Over the ground, which the walker does not leave where it falls by a step or a walkable slope.
Stand moveOverGround(const Scene& scene, const Body& body, Walker& walker, Stand stand) {
  const Vec2 motion = kTick * walker.velocity.xy();
  const double distance = length(motion);
  if (distance == 0) return stand;
  const double longest = std::max(body.radius / 2, distance / kMaxParts);
  const int parts = static_cast<int>(std::ceil(distance / longest));
  Vec2 displacement{0, 0};
  bool collided = false;
  for (int i = 0; i < parts; ++i) {
    const Move move = movedAlong(scene, body, stand, (1.0 / parts) * motion);
    collided = collided || move.collided;
    displacement = displacement + move.displacement;
    stand = move.stand;
    const double drop =
        std::max(body.stepHeight, kSteepestWalk * length(move.displacement)) + kSkin;
    if (walker.isOnGround && stand.feet.z - stand.zSupport <= drop)
      stand = movedVertically(scene, body, stand, stand.zSupport - stand.feet.z);
    if (move.displacement == Vec2{}) break;
  }
  if (collided) {
    walker.velocity.x = kTicksPerSecond * displacement.x;
    walker.velocity.y = kTicksPerSecond * displacement.y;
  }
  return stand;
}

/// Up or down, by input or by weight.
Stand moveUpright(const Scene& scene, const Body& body, Walker& walker, const Stand& stand) {
  double& speed = walker.velocity.z;
  const double gravity = walker.isFlying ? 0 : kGravity;
  const double rise = kTick * (speed - gravity * kTick / 2);
  speed = std::max(speed - gravity * kTick, -kFastestFall);
  const Stand to = movedVertically(scene, body, stand, rise);
  const bool collided = to.feet.z != stand.feet.z + rise;
  if (collided) speed = 0;
  walker.isOnGround = collided && rise < 0 && !walker.isFlying;
  return to;
}

void put(Walker& walker, const Stand& stand) {
  walker.sector = stand.sector;
  walker.feet = stand.feet;
}

}  // namespace

Walker walkerAt(const Scene& scene, SectorId sector, Vec3 eye, double angle, double pitch) {
  Walker walker{sector, eye, {}, wrappedDegrees(angle), std::clamp(pitch, -kMaxPitch, kMaxPitch)};
  for (const double crouch : {0.0, 1.0}) {
    const Body body = bodyOf(scene.level(), crouch);
    // Down from the eye, and not through a floor; then up onto what else is under the disc.
    const Body point{0, 0, 0, 0};
    const auto column = standAt(scene, point, sector, eye, eye.z, body.eyeHeight, 0);
    if (!column) return walker;
    const Stand below = movedVertically(scene, point, *column, -body.eyeHeight);
    put(walker, below);
    const double zClimb = below.feet.z + body.stepHeight;
    const auto stand = standAt(scene, body, below.sector, below.feet, zClimb, 0, body.stepHeight);
    if (!stand || !stand->hasRoomFor(body.height)) continue;
    put(walker, *stand);
    walker.crouch = crouch;
    return walker;
  }
  return walker;
}

Walker walked(const Scene& scene, const Walker& before, const WalkInput& input) {
  Walker walker = before;
  turn(walker, input);
  if (input.toggleFlight) walker.isFlying = !walker.isFlying;
  if (walker.isFlying) walker.isOnGround = false;
  auto stand = standOf(scene, walker, bodyOf(scene.level(), walker.crouch));
  if (!stand || !stand->hasRoomFor(bodyOf(scene.level(), walker.crouch).height)) {
    walker.velocity = {};
    return walker;
  }
  crouch(scene, walker, *stand, input.crouch);
  const Body body = bodyOf(scene.level(), walker.crouch);
  accelerate(walker, input);
  if (input.jump && walker.isOnGround) {
    walker.velocity.z = kJumpSpeed;
    walker.isOnGround = false;
  }
  put(walker, moveOverGround(scene, body, walker, *stand));
  stand = standOf(scene, walker, body);
  if (!stand) return walker;
  if (!walker.isFlying && walker.velocity.z <= 0 && stand->feet.z <= stand->zSupport + kSkin) {
    walker.velocity.z = 0;
    walker.isOnGround = true;
  } else {
    stand = moveUpright(scene, body, walker, *stand);
  }
  put(walker, *stand);
  return walker;
}

}  // namespace hearth
