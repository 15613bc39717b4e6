#include "walk/walker.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "level/locate.h"
#include "level/openings.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;

bool isIn(const Level& level, SectorId sector, Vec3 p) {
  return contains(level, level[sector], p, kPositionSlack);
}

/// The sector that a short move from `sector` to `p` leads to.
std::optional<SectorId> sectorAfter(const Level& level, SectorId sector, Vec3 p) {
  if (isIn(level, sector, p)) return sector;
  for (const Segment& segment : level.segmentsOf(level[sector]))
    for (const WallPiece& piece : segment.pieces)
      if (const Opening* opening = std::get_if<Opening>(&piece.content))
        if (isIn(level, opening->next, p)) return opening->next;
  return std::nullopt;
}

double eyeHeight(const Level& level) { return level.player.value_or(Player{}).eyeHeight; }

}  // namespace

Walker walkerAt(const Level& level, SectorId sector, Vec3 eye, double angle, double pitch) {
  const double zFloor = level[sector].airBottom(eye.xy());
  return {sector, {eye.x, eye.y, std::max(zFloor, eye.z - eyeHeight(level))}, {}, angle, pitch};
}

Walker walked(const Level& level, const Walker& walker, const WalkInput& input) {
  Walker after = walker;
  const double turned = std::fmod(walker.angle + input.turn / 1000.0, 360.0);
  after.angle = turned < 0 ? turned + 360 : turned;
  after.pitch = std::clamp(walker.pitch + input.pitch / 1000.0, -60.0, 60.0);
  const SinCos heading = sinCosDegrees(after.angle);
  const Vec2 ahead{heading.cos, heading.sin};
  const double speed = (input.run ? 5.0 : 2.5) / kFullShare;
  const Vec2 velocity = speed * (input.forward * ahead + input.right * turned90(ahead));
  const Vec3 wanted = walker.feet + kTick * Vec3{velocity.x, velocity.y, 0};
  if (const auto sector = sectorAfter(level, walker.sector, wanted)) {
    after.sector = *sector;
    after.feet = wanted;
  }
  return after;
}

Eye eyeOf(const Level& level, const Walker& walker) {
  const double top = level[walker.sector].airTop(walker.feet.xy());
  const double z = std::min(walker.feet.z + eyeHeight(level), top);
  return {walker.sector, {walker.feet.x, walker.feet.y, z}, walker.angle, walker.pitch};
}

Eye eyeBetween(const Level& level, const Walker& before, const Walker& after, double share) {
  const Eye from = eyeOf(level, before);
  Eye eye = eyeOf(level, after);
  const Vec3 point = from.point + share * (eye.point - from.point);
  const double turn = std::remainder(eye.angle - from.angle, 360.0);
  eye.angle = from.angle + share * turn;
  eye.pitch = from.pitch + share * (eye.pitch - from.pitch);
  if (isIn(level, eye.sector, point)) eye.point = point;
  return eye;
}

}  // namespace hearth
