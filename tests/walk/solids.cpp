#include "walk_tests/solids.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "level/locate.h"
#include "level/openings.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth::random_walks {

namespace {

constexpr double kEdgeInset = 3 * kSkin;

/// Fraction of the radius, by which a wall without thickness that points to the axis is looked at
/// from beside. What is within as much of the body's edge can be missed.
constexpr double kAsideFraction = 1.0 / 32;

struct Exit {
  double distance = kInfinity;
  double fraction = 0;
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
    const double fraction = cross(direction, eye - wall.p0) / cross(direction, along);
    if (fraction < 0 || fraction > 1 || distance < from - 1e-9 || distance >= exit.distance)
      continue;
    exit = {distance, fraction, id};
  }
  return exit;
}

/// How far of [from, to] along the line is between the sector's floor and ceiling.
double inAir(const Scene& scene, const Sector& sector, Vec3 eye, Vec2 direction, double from,
             double to) {
  double last = to;
  const auto cut = [&](double clearFrom, double clearTo) {
    if (clearTo >= -kEdgeInset) return;
    if (clearFrom <= 0)
      last = std::min(last, from);
    else
      last = std::min(last, from + (to - from) * clearFrom / (clearFrom - clearTo));
  };
  const Vec2 a = eye.xy() + from * direction;
  const Vec2 b = eye.xy() + to * direction;
  cut(eye.z - scene.airBottom(sector, a), eye.z - scene.airBottom(sector, b));
  cut(scene.airTop(sector, a) - eye.z, scene.airTop(sector, b) - eye.z);
  return last;
}

/// Even directions, straight to every wall, and past both sides of every vertex.
std::vector<Vec2> linesFrom(Vec2 p, const std::vector<const Segment*>& walls, double radius,
                            int directions) {
  std::vector<Vec2> lines;
  for (int i = 0; i < directions; ++i) {
    const SinCos turn = sinCosDegrees(360.0 * i / directions + 0.37);
    lines.push_back({turn.cos, turn.sin});
  }
  for (const Segment* wall : walls) {
    const Vec2 across = nearestOnSegment(wall->p0, wall->p1, p) - p;
    if (length(across) > 0) lines.push_back((1 / length(across)) * across);
    const Vec2 towards = wall->p0 - p;
    const double distance = length(towards);
    if (distance >= radius || distance == 0) continue;
    for (const double side : {-1e-4, 1e-4}) {
      const Vec2 past = (1 / distance) * towards + side * turned90((1 / distance) * towards);
      lines.push_back((1 / length(past)) * past);
    }
  }
  return lines;
}

/// Where to look from at the walls that `p` is in line with and does not see: the level has walls
/// without thickness. The cylinder round such a place that is so much smaller is in that round `p`.
std::vector<Vec2> placesBeside(Vec2 p, const std::vector<const Segment*>& walls, double aside) {
  std::vector<Vec2> places;
  for (const Segment* wall : walls) {
    const Vec2 along = (1 / wall->length) * (wall->p1 - wall->p0);
    if (std::abs(cross(along, p - wall->p0)) < aside / 2)
      places.push_back(p + aside * turned90(along));
  }
  return places;
}

/// Heights of a body on `zFeet`: five even ones, and the middle of what it is beside of every piece
/// of these walls, which may all lie between two of the five.
std::vector<double> heightsOf(const Scene& scene, const Body& body, double zFeet,
                              const std::vector<const Segment*>& walls) {
  const double zLow = zFeet + kEdgeInset;
  const double zHigh = zFeet + body.height - kEdgeInset;
  std::vector<double> heights;
  for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0})
    heights.push_back(std::lerp(zLow, zHigh, fraction));
  for (const Segment* wall : walls)
    for (const WallPiece& piece : scene.piecesOf(*wall)) {
      const double zBottom = std::max(zLow, piece.zBottom);
      const double zTop = std::min(zHigh, piece.zTop);
      if (zBottom < zTop) heights.push_back(std::midpoint(zBottom, zTop));
    }
  std::ranges::sort(heights);
  const auto repeated = std::ranges::unique(heights);
  heights.erase(repeated.begin(), repeated.end());
  return heights;
}

}  // namespace

Solids::Solids(const Scene& scene) : scene_(scene) {
  const auto opens = [&](const Segment& back, SectorId next, const WallPiece& piece) {
    return std::ranges::any_of(scene.piecesOf(back), [&](const WallPiece& other) {
      const Opening* opening = std::get_if<Opening>(&other.content);
      return opening && opening->next == next &&
             std::abs(other.zBottom - piece.zBottom) < kEdgeInset &&
             std::abs(other.zTop - piece.zTop) < kEdgeInset;
    });
  };
  for (const Segment& segment : scene.level().segments)
    for (const WallPiece& piece : scene.piecesOf(segment))
      if (const Opening* opening = std::get_if<Opening>(&piece.content))
        if (!opens(scene[opening->twin], segment.sector, piece)) oneWays_.push_back(opening->twin);
}

Solids::Line Solids::follow(SectorId sector, Vec3 from, Vec2 direction, double length) const {
  // From a vertex or a wall itself nobody could say which sector the line is in.
  from = nudgedInside(scene_, scene_[sector], from);
  double free = 0;
  for (int i = 0; i < 1000; ++i) {
    const Exit exit = exitOf(scene_.level(), scene_[sector], from.xy(), direction, free);
    const double to = std::min(exit.distance, length);
    const double air = inAir(scene_, scene_[sector], from, direction, free, to);
    if (air < to) return {air, sector};
    free = std::max(free, to);
    if (exit.distance >= length) return {length, sector};
    std::optional<SectorId> next;
    visitWallColumn(
        scene_, scene_[exit.segment], exit.fraction, [](SurfaceId, double, double) {},
        [&](const Opening& opening, double zBottom, double zTop) {
          if (from.z >= zBottom - kEdgeInset && from.z <= zTop + kEdgeInset) next = opening.next;
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
  if (!contains(scene_, scene_[at], from, kPositionSlack)) return std::nullopt;
  const Vec2 toThere = to.xy() - from.xy();
  const Line line = follow(at, from, (1 / length(toThere)) * toThere, length(toThere));
  return line.free < length(toThere) ? std::nullopt : std::optional(line.end);
}

bool Solids::isBesideOneWay(Vec2 p, double radius) const {
  return std::ranges::any_of(oneWays_, [&](SegmentId id) {
    return length(nearestOnSegment(scene_[id].p0, scene_[id].p1, p) - p) < radius;
  });
}

SectorId Solids::inColumn(SectorId sector, Vec3 p) const {
  for (int i = 0; i < 1000; ++i) {
    const Sector& here = scene_[sector];
    if (here.floor.flatPortal && p.z < here.floor.z)
      sector = sectorAcross(scene_.level(), scene_[*here.floor.flatPortal], FlatPortalSide::Lower,
                            p.xy());
    else if (here.ceiling.flatPortal && p.z > here.ceiling.z)
      sector = sectorAcross(scene_.level(), scene_[*here.ceiling.flatPortal], FlatPortalSide::Upper,
                            p.xy());
    else
      break;
  }
  return sector;
}

std::vector<const Segment*> Solids::wallsWithin(Vec2 p, double radius) const {
  std::vector<const Segment*> walls;
  for (const Segment& segment : scene_.level().segments)
    if (length(nearestOnSegment(segment.p0, segment.p1, p) - p) < radius) walls.push_back(&segment);
  return walls;
}

bool Solids::isFree(SectorId sector, Vec3 feet, const Body& body, int directions) const {
  const Vec2 p = feet.xy();
  const std::vector<const Segment*> walls = wallsWithin(p, body.radius);
  const std::vector<Vec2> lines = linesFrom(p, walls, body.radius, directions);
  const double aside = body.radius * kAsideFraction;
  for (const double z : heightsOf(scene_, body, feet.z, walls)) {
    const Vec3 axis{p.x, p.y, z};
    const SectorId at = inColumn(sector, axis);
    if (!contains(scene_, scene_[at], axis, kPositionSlack)) return false;
    const auto isFreeAlong = [&](SectorId from, Vec3 eye, double length) {
      return [=, this](Vec2 line) { return freeAlong(from, eye, line, length) >= length; };
    };
    if (!std::ranges::all_of(lines, isFreeAlong(at, axis, body.radius))) return false;
    for (const Vec2 q : placesBeside(p, walls, aside)) {
      const Vec3 eye{q.x, q.y, z};
      const auto there = sectorAlong(at, axis, eye);
      const std::vector<Vec2> others = linesFrom(q, walls, body.radius - aside, 0);
      if (!there || !std::ranges::all_of(others, isFreeAlong(*there, eye, body.radius - aside)))
        return false;
    }
  }
  return true;
}

}  // namespace hearth::random_walks
