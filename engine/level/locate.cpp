#include "level/locate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "level/walls_in.h"
#include "math/check.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr double kAnyDistance = std::numeric_limits<double>::infinity();

bool inBox(const Sector& sector, Vec2 p, double slack) {
  return grown(sector.box, slack).contains(p);
}

struct Nearest {
  double distance = kAnyDistance;
  Vec2 point;
  const Segment* segment = nullptr;
};

/// Of the walls that come into a box.
Nearest nearestWallIn(const Level& level, const Sector& sector, const Box& box, Vec2 p) {
  Nearest best;
  forEachWallIn(level, sector, box, [&](const Segment& segment) {
    const Vec2 point = nearestOnSegment(segment.p0, segment.p1, p);
    const double distance = length(point - p);
    if (distance < best.distance) best = {distance, point, &segment};
  });
  return best;
}

Nearest nearestWall(const Level& level, const Sector& sector, Vec2 p) {
  const WallGrid* const grid = level.wallGridOf(sector);
  double reach = grid ? grid->metresPerCell() : kAnyDistance;
  while (true) {
    const Nearest best = nearestWallIn(level, sector, boxAround(p, reach), p);
    if (best.distance <= reach) return best;
    reach *= 2;
  }
}

/// Metres that a point near `p` must move so that rounding cannot hide the difference.
double nudgeAt(Vec2 p) {
  const double size = std::max(std::abs(p.x), std::abs(p.y));
  return std::max(kNudge, 64 * std::numeric_limits<double>::epsilon() * size);
}

/// Whether no wall comes nearer than `clearance`.
bool isAwayFromWalls(const Level& level, const Sector& sector, Vec2 p, double clearance) {
  const Box near = boxAround(p, 2 * clearance);
  bool isAway = true;
  forEachWallIn(level, sector, near, [&](const Segment& wall) {
    if (isAway && touch(boxOf(wall.p0, wall.p1), near))
      isAway = length(nearestOnSegment(wall.p0, wall.p1, p) - p) >= clearance;
  });
  return isAway;
}

bool isClear(const Level& level, const Sector& sector, Vec2 p, double clearance) {
  return isAwayFromWalls(level, sector, p, clearance) && contains(level, sector, p);
}

/// A point of the sector that is at least a sixteenth of the nudge away from its walls: `p` itself,
/// or one of the smallest ring of candidates that has such a point.
Vec2 nudgedInside(const Level& level, const Sector& sector, Vec2 p) {
  const double nudge = nudgeAt(p);
  if (isClear(level, sector, p, nudge / 16)) return p;
  const Nearest wall = nearestWall(level, sector, p);
  const Vec2 inward = turned90(wall.segment->p1 - wall.segment->p0);
  // In an acute corner the nearest clear point is far from the vertex.
  constexpr int kDirections = 1440;
  for (double radius = nudge; radius < 1e6 * nudge; radius *= 2) {
    Vec2 best = p;
    double clearance = 0;
    const Vec2 straight = wall.point + (radius / length(inward)) * inward;
    if (isClear(level, sector, straight, nudge / 16)) return straight;
    for (int i = 0; i < kDirections; ++i) {
      // Points on a square around the point; their spacing in angle does not matter.
      const double along = 8.0 * i / kDirections;
      const double edge = along - std::floor(along / 2) * 2 - 1;
      const Vec2 ring[] = {{edge, -1}, {1, edge}, {-edge, 1}, {-1, -edge}};
      const Vec2 candidate = wall.point + radius * ring[static_cast<int>(along / 2)];
      if (!contains(level, sector, candidate)) continue;
      const double found = nearestWall(level, sector, candidate).distance;
      if (found > clearance) best = candidate, clearance = found;
    }
    if (clearance >= nudge / 16) return best;
  }
  return p;
}

Vec3 nudgedInto(AirColumn air, Vec2 xy, double z) {
  const double nudge = std::min(
      nudgeAt({z, 0}), (air.zTop - air.zBottom) / 4);  // the air may be less than two nudges high
  const double bottom = air.zBottom + nudge;
  return {xy.x, xy.y, std::clamp(z, bottom, std::max(bottom, air.zTop - nudge))};
}

/// The walls on which a point lies.
class WallsAt {
 public:
  explicit WallsAt(Vec2 p) : p_(p) {}

  void add(const Segment& segment) {
    if (segment.p1 != p_) addDirection(segment.p1, 1);
    if (segment.p0 != p_) addDirection(segment.p0, -1);
  }

  /// Whether there is air at the point. A wall that runs away from the point has air clockwise
  /// of it; a wall that runs towards the point, counter-clockwise. Two opposite walls that
  /// coincide, for example because a pillar stands in the border, have no air between them.
  bool hasAir() const {
    return std::ranges::any_of(directions_,
                               [](const Direction& direction) { return direction.walls != 0; });
  }

 private:
  struct Direction {
    Vec2 to;
    int walls;  ///< number of walls along it, less those against it
  };

  void addDirection(Vec2 to, int walls) {
    for (Direction& direction : directions_)
      if (orientation(p_, direction.to, to) == 0 && dot(direction.to - p_, to - p_) > 0) {
        direction.walls += walls;
        return;
      }
    directions_.push_back({to, walls});
  }

  Vec2 p_;
  std::vector<Direction> directions_;
};

/// Whether a point is within `slack` of a wall that has air in front of it at that place.
bool isBesideWall(const Level& level, const Sector& sector, Vec2 p, double slack) {
  bool isBeside = false;
  forEachWallIn(level, sector, boxAround(p, slack), [&](const Segment& segment) {
    const Vec2 wall = nearestOnSegment(segment.p0, segment.p1, p);
    if (isBeside || length(wall - p) > slack) return;
    const Vec2 along = segment.p1 - segment.p0;
    const Vec2 before = wall + (slack / length(along)) * turned90(along);
    isBeside = contains(level, sector, wall) || contains(level, sector, before);
  });
  return isBeside;
}

}  // namespace

bool contains(const Level& level, const Sector& sector, Vec2 p) {
  if (!inBox(sector, p, 0)) return false;
  bool inside = false;
  WallsAt walls(p);
  // The point is inside if an odd number of walls lies to the left of it.
  forEachWallIn(level, sector, {{-kAnyDistance, p.y}, p}, [&](const Segment& segment) {
    const Vec2 a = segment.p0;
    const Vec2 b = segment.p1;
    const bool aBelow = a.y <= p.y;
    const bool bBelow = b.y <= p.y;
    const bool nearY = std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
    if (!nearY) return;
    const int side = orientation(a, b, p);
    if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x))
      walls.add(segment);
    else if (aBelow != bBelow && (side > 0) == bBelow)
      inside = !inside;
  });
  return inside || walls.hasAir();
}

bool contains(const Scene& scene, const Sector& sector, Vec3 p, double slack) {
  if (!inBox(sector, p.xy(), slack)) return false;
  if (p.z < scene.airBottom(sector, p.xy()) - slack || p.z > scene.airTop(sector, p.xy()) + slack)
    return false;
  return contains(scene.level(), sector, p.xy()) ||
         isBesideWall(scene.level(), sector, p.xy(), slack);
}

Vec3 nudgedInside(const Scene& scene, const Sector& sector, Vec3 p) {
  const Vec2 xy = nudgedInside(scene.level(), sector, p.xy());
  return nudgedInto({scene.airBottom(sector, xy), scene.airTop(sector, xy)}, xy, p.z);
}

Vec3 nudgedInside(const Level& level, const Sector& sector, Vec3 p) {
  const Vec2 xy = nudgedInside(level, sector, p.xy());
  return nudgedInto({sector.authoredBottom(xy), sector.authoredTop(xy)}, xy, p.z);
}

SectorId sectorAcross(const Level& level, const FlatPortal& flatPortal, FlatPortalSide to, Vec2 p) {
  const std::vector<SectorId>& members = flatPortal.members(to);
  CHECK(!members.empty(), flatPortal.name);
  SectorId best = members.front();
  double distance = kAnyDistance;
  for (const SectorId member : members) {
    if (contains(level, level[member], p)) return member;
    const double found = nearestWall(level, level[member], p).distance;
    if (found < distance) best = member, distance = found;
  }
  return best;
}

}  // namespace hearth
