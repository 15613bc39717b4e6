#include "hearth/flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "level/locate.h"
#include "level/openings.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

constexpr double kSpeed = 3;           // m/s: a brisk walk
constexpr double kFastFactor = 4;      // with Shift
constexpr double kTurnSpeed = 120;     // degrees/s
constexpr double kMaxPitch = 60;       // degrees, what the projection takes
constexpr double kLongestTime = 0.25;  // s

/// Metres. Moves are made in steps of this, so that none passes a wall or a whole sector.
constexpr double kStep = 0.05;

/// How steep a slope the eye follows up or down while it flies straight on: metres per metre.
constexpr double kClimb = 2;

/// Metres that the eye is kept off a wall along which it slides, so that the next step along the
/// wall does not end in it.
constexpr double kOffWall = 1e-4;

struct Place {
  SectorId sector;
  Vec3 eye;
};

bool isIn(const Level& level, SectorId sector, Vec3 p) {
  return contains(level, level[sector], p, kPositionSlack);
}

/// Through one of the sector's openings that `p` is at, within a step.
std::optional<SectorId> throughOpening(const Level& level, const Sector& sector, Vec3 p) {
  std::optional<SectorId> found;
  for (const Segment& segment : level.segmentsOf(sector)) {
    const Vec2 nearest = nearestOnSegment(segment.p0, segment.p1, p.xy());
    if (length(nearest - p.xy()) > 2 * kStep || segment.length == 0) continue;
    const double share = std::min(1.0, length(nearest - segment.p0) / segment.length);
    visitWallColumn(
        level, segment, share, [](SurfaceId, double, double) {},
        [&](const Opening& opening, double zBottom, double zTop) {
          if (!found && p.z >= zBottom && p.z <= zTop && isIn(level, opening.next, p))
            found = opening.next;
        });
  }
  return found;
}

/// Through the sector's floor or ceiling, where these are flat portals.
std::optional<SectorId> throughFlat(const Level& level, const Sector& sector, Vec3 p) {
  const auto through = [&](const Flat& flat, Side side) -> std::optional<SectorId> {
    if (!flat.interface) return std::nullopt;
    const SectorId next = across(level, level[*flat.interface], side, p.xy());
    return isIn(level, next, p) ? std::optional(next) : std::nullopt;
  };
  if (p.z < sector.floor.z) return through(sector.floor, Side::Lower);
  if (p.z > sector.ceiling.z) return through(sector.ceiling, Side::Upper);
  return std::nullopt;
}

/// Where one step to `p` leads: on in the sector, or to one that it opens to.
std::optional<Place> stepTo(const Level& level, SectorId from, Vec3 p) {
  if (isIn(level, from, p)) return Place{from, p};
  const Sector& sector = level[from];
  if (const auto next = throughFlat(level, sector, p)) return Place{*next, p};
  if (const auto next = throughOpening(level, sector, p)) return Place{*next, p};
  return std::nullopt;
}

/// One step along a slope that is in the way.
std::optional<Place> climbTo(const Level& level, const Place& from, Vec3 p) {
  const Sector& sector = level[from.sector];
  const double z = std::clamp(p.z, sector.airBottom(p.xy()),
                              std::max(sector.airBottom(p.xy()), sector.airTop(p.xy())));
  if (std::abs(z - p.z) > kClimb * length(p.xy() - from.eye.xy())) return std::nullopt;
  return stepTo(level, from.sector, {p.x, p.y, z});
}

/// The part of a move that runs along the nearest wall of the sector.
Vec2 alongNearestWall(const Level& level, const Place& from, Vec2 move) {
  double nearest = std::numeric_limits<double>::infinity();
  Vec2 slide = {0, 0};
  for (const Segment& segment : level.segmentsOf(level[from.sector])) {
    const Vec2 foot = nearestOnSegment(segment.p0, segment.p1, from.eye.xy());
    const double distance = length(foot - from.eye.xy());
    if (distance >= nearest || segment.length == 0) continue;
    nearest = distance;
    const Vec2 along = (1 / segment.length) * (segment.p1 - segment.p0);
    slide = dot(move, along) * along + kOffWall * turned90(along);
  }
  return slide;
}

/// One step of a move: the whole of it, or what is left when it slides along what is in the way.
Place step(const Level& level, const Place& from, Vec3 move) {
  const Vec2 slide = alongNearestWall(level, from, move.xy());
  const Vec3 tries[] = {
      move, {move.x, move.y, 0}, {slide.x, slide.y, move.z}, {slide.x, slide.y, 0}, {0, 0, move.z}};
  for (const Vec3 attempt : tries) {
    if (const auto place = stepTo(level, from.sector, from.eye + attempt)) return *place;
    if (const auto place = climbTo(level, from, from.eye + attempt)) return *place;
  }
  return from;
}

Vec3 velocity(const Flight& flight, const FlightControls& controls) {
  const SinCos heading = sinCosDegrees(flight.angle);
  const Vec2 direction{heading.cos, heading.sin};
  const Vec2 across = controls.forward * direction + controls.right * turned90(direction);
  const Vec3 wanted{across.x, across.y, controls.up};
  const double size = length(wanted);
  if (size == 0) return {};
  return (kSpeed * (controls.isFast ? kFastFactor : 1) / size) * wanted;
}

/// An angle in degrees, in [0, 360).
double wrapped(double angle) {
  const double turned = std::fmod(angle, 360);
  const double positive = turned < 0 ? turned + 360 : turned;
  return positive < 360 ? positive : 0;  // a tiny negative angle rounds up to 360
}

}  // namespace

Flight advance(const Level& level, Flight flight, const FlightControls& controls, double seconds) {
  const double time = seconds > 0 ? std::min(seconds, kLongestTime) : 0;
  flight.angle = wrapped(flight.angle + controls.turn * kTurnSpeed * time + controls.turnDegrees);
  flight.pitch = std::clamp(flight.pitch + controls.pitchDegrees, -kMaxPitch, kMaxPitch);

  const Vec3 move = time * velocity(flight, controls);
  const int steps = static_cast<int>(std::ceil(length(move) / kStep));
  Place place{flight.sector, flight.eye};
  for (int i = 0; i < steps; ++i) place = step(level, place, (1.0 / steps) * move);
  flight.sector = place.sector;
  flight.eye = place.eye;
  return flight;
}

}  // namespace hearth
