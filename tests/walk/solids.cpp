#include "walk_tests/solids.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "level/locate.h"
#include "level/openings.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth::random_walks {

namespace {

constexpr double kHair = 3 * kSkin;

struct Exit {
  double distance = kNowhere;
  double share = 0;
  SegmentId segment;
};

/// Where a line leaves a sector: the nearest wall beyond `from` whose front it meets.
Exit exitOf(const Level& level, const Sector& sector, Vec2 eye, Vec2 direction, double from) {
  Exit exit;
  for (std::size_t i = 0; i < sector.segmentCount; ++i) {
    const SegmentId id(sector.firstSegment.index() + i);
    const Segment& wall = level[id];
    const Vec2 along = wall.p1 - wall.p0;
    const double facing = cross(along, direction);
    if (facing >= 0) continue;  // parallel, or from behind
    const double distance = cross(along, wall.p0 - eye) / facing;
    const double share = cross(direction, eye - wall.p0) / cross(direction, along);
    if (share < 0 || share > 1 || distance < from - 1e-9 || distance >= exit.distance) continue;
    exit = {distance, share, id};
  }
  return exit;
}

/// How far of [from, to] along the line is between the sector's floor and ceiling.
double inAir(const Sector& sector, Vec3 eye, Vec2 direction, double from, double to) {
  double last = to;
  const auto cut = [&](double clearFrom, double clearTo) {
    if (clearTo >= -kHair) return;
    if (clearFrom <= 0)
      last = std::min(last, from);
    else
      last = std::min(last, from + (to - from) * clearFrom / (clearFrom - clearTo));
  };
  const Vec2 a = eye.xy() + from * direction;
  const Vec2 b = eye.xy() + to * direction;
  cut(eye.z - sector.airBottom(a), eye.z - sector.airBottom(b));
  cut(sector.airTop(a) - eye.z, sector.airTop(b) - eye.z);
  return last;
}

}  // namespace

Solids::Solids(const Level& level) : level_(level) {
  const auto opens = [&](const Segment& back, SectorId next, const WallPiece& piece) {
    return std::ranges::any_of(back.pieces, [&](const WallPiece& other) {
      const Opening* opening = std::get_if<Opening>(&other.content);
      return opening && opening->next == next && std::abs(other.zBottom - piece.zBottom) < kHair &&
             std::abs(other.zTop - piece.zTop) < kHair;
    });
  };
  for (const Segment& segment : level.segments)
    for (const WallPiece& piece : segment.pieces)
      if (const Opening* opening = std::get_if<Opening>(&piece.content))
        if (!opens(level[opening->twin], segment.sector, piece)) oneWays_.push_back(opening->twin);
}

Solids::Line Solids::follow(SectorId sector, Vec3 from, Vec2 direction, double length) const {
  // From a vertex or a wall itself nobody could say which sector the line is in.
  from = nudgedInside(level_, level_[sector], from);
  double free = 0;
  for (int i = 0; i < 1000; ++i) {
    const Exit exit = exitOf(level_, level_[sector], from.xy(), direction, free);
    const double to = std::min(exit.distance, length);
    const double air = inAir(level_[sector], from, direction, free, to);
    if (air < to) return {air, sector};
    free = std::max(free, to);
    if (exit.distance >= length) return {length, sector};
    std::optional<SectorId> next;
    visitWallColumn(
        level_, level_[exit.segment], exit.share, [](SurfaceId, double, double) {},
        [&](const Opening& opening, double zBottom, double zTop) {
          if (from.z >= zBottom - kHair && from.z <= zTop + kHair) next = opening.next;
        });
    if (!next) return {free, sector};
    sector = *next;
  }
  return {free, sector};
}

double Solids::freeAlong(SectorId sector, Vec3 from, Vec2 direction, double length) const {
  return follow(sector, from, direction, length).free;
}

std::optional<SectorId> Solids::sectorAlong(SectorId sector, Vec3 from, Vec3 to) const {
  const SectorId at = inColumn(sector, from);
  if (!contains(level_, level_[at], from, kPositionSlack)) return std::nullopt;
  const Vec2 way = to.xy() - from.xy();
  const Line line = follow(at, from, (1 / length(way)) * way, length(way));
  return line.free < length(way) ? std::nullopt : std::optional(line.end);
}

bool Solids::isBesideOneWay(Vec2 p, double radius) const {
  return std::ranges::any_of(oneWays_, [&](SegmentId id) {
    return length(nearestOnSegment(level_[id].p0, level_[id].p1, p) - p) < radius;
  });
}

SectorId Solids::inColumn(SectorId sector, Vec3 p) const {
  for (int i = 0; i < 1000; ++i) {
    const Sector& here = level_[sector];
    if (here.floor.interface && p.z < here.floor.z)
      sector = across(level_, level_[*here.floor.interface], Side::Lower, p.xy());
    else if (here.ceiling.interface && p.z > here.ceiling.z)
      sector = across(level_, level_[*here.ceiling.interface], Side::Upper, p.xy());
    else
      break;
  }
  return sector;
}

bool Solids::isFree(SectorId sector, Vec3 feet, const Body& body, int directions) const {
  const Vec2 p = feet.xy();
  std::vector<Vec2> lines;
  for (int i = 0; i < directions; ++i) {
    const SinCos turn = sinCosDegrees(360.0 * i / directions + 0.37);
    lines.push_back({turn.cos, turn.sin});
  }
  for (const Segment& segment : level_.segments) {
    const Vec2 towards = segment.p0 - p;
    const double distance = length(towards);
    if (distance >= body.radius || distance == 0) continue;
    for (const double side : {-1e-4, 1e-4}) {
      const Vec2 past = (1 / distance) * towards + side * turned90((1 / distance) * towards);
      lines.push_back((1 / length(past)) * past);
    }
  }
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec3 axis{p.x, p.y, feet.z + kHair + share * (body.height - 2 * kHair)};
    const SectorId at = inColumn(sector, axis);
    if (!contains(level_, level_[at], axis, kPositionSlack)) return false;
    for (const Vec2 line : lines)
      if (freeAlong(at, axis, line, body.radius) < body.radius) return false;
  }
  return true;
}

}  // namespace hearth::random_walks
