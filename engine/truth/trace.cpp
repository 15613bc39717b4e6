#include "truth/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "level/locate.h"
#include "math/check.h"
#include "math/predicates.h"
#include "math/tolerance.h"
#include "truth/ray.h"
#include "truth/wall_hit.h"

namespace hearth {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Steps from sector to sector after which something is wrong: no level has so many in a line.
constexpr int kMaxSteps = 100'000;

/// How the ray came into its sector: it starts there, it came through a wall whose twin this is, or
/// through a flat portal at this place.
using Door = std::variant<std::monostate, SegmentId, Vec2>;

/// Where the ray is.
struct Stage {
  SectorId sector;
  double t;
  Door door;
};

/// Whether the ray, past its door, is still to come to the segment, which it crosses somewhere.
bool isAhead(const Level& level, const Ray& ray, const Door& door, const Segment& segment) {
  if (const SegmentId* id = std::get_if<SegmentId>(&door)) {
    const Segment& twin = level[*id];
    return meetsFirst(ray.origin.xy(), twin.p0, twin.p1, segment.p0, segment.p1);
  }
  if (const Vec2* place = std::get_if<Vec2>(&door))
    return orientation(segment.p0, segment.p1, *place) >= 0;
  return true;
}

/// Every vertex is to the right of the ray or, as also those on its line, not; exactly. So every
/// loop is crossed as often inwards as outwards, even by a ray through its vertices.
bool isRight(const Ray& ray, Vec2 vertex) {
  return orientation(ray.origin.xy(), ray.farPoint, vertex) > 0;
}

/// The segment through which the ray leaves its sector on the map. None for vertical rays.
std::optional<SegmentId> findExit(const Level& level, const Ray& ray, const Stage& stage) {
  const Vec2 eye = ray.origin.xy();
  const Sector& sector = level[stage.sector];
  std::optional<SegmentId> best;
  for (std::size_t i = 0; i < sector.segmentCount; ++i) {
    const SegmentId id(sector.firstSegment.index() + i);
    const Segment& segment = level[id];
    if (isRight(ray, segment.p0) || !isRight(ray, segment.p1)) continue;  // missed, or a back
    if (orientation(segment.p0, segment.p1, eye) <= 0) continue;          // behind the origin
    if (!isAhead(level, ray, stage.door, segment)) continue;
    if (!best || meetsFirst(eye, segment.p0, segment.p1, level[*best].p0, level[*best].p1))
      best = id;
  }
  return best;
}

/// Parameter at which the ray crosses the segment.
double crossingOf(const Ray& ray, const Segment& segment) {
  const Vec2 eye = ray.origin.xy();
  const Vec2 along = segment.p1 - segment.p0;
  const Vec2 direction = ray.direction.xy();
  const auto nearest = [&](Vec2 p) { return dot(p - eye, direction) / dot(direction, direction); };
  // Whatever the rounding of a wall that is nearly in line with the ray, it is between its ends.
  const auto [first, last] = std::minmax({nearest(segment.p0), nearest(segment.p1)});
  const double speed = cross(direction, along);
  return speed > 0 ? std::clamp(cross(segment.p0 - eye, along) / speed, first, last) : first;
}

/// Parameter at which the ray comes to the floor (ceiling) of its sector, or kNever.
double meetFlat(const Ray& ray, const Sector& sector, bool isFloor) {
  const Flat& flat = isFloor ? sector.floor : sector.ceiling;
  const std::optional<Slope>& slope = isFloor ? sector.floorSlope : sector.ceilingSlope;
  if (flat.isSky && ray.kind == RayKind::Light) return kNever;
  const double sign = isFloor ? 1 : -1;
  const Vec2 gradient = slope ? slope->gradient : Vec2{};
  const double z = slope ? slope->zAt(ray.origin.xy()) : flat.z;
  const double distance = sign * (ray.origin.z - z);
  const double speed = -sign * (ray.direction.z - dot(gradient, ray.direction.xy()));
  return speed > 0 ? distance / speed : kNever;
}

TruthHit flatHit(const Ray& ray, SectorId id, const Sector& sector, bool isFloor, double t) {
  const Flat& flat = isFloor ? sector.floor : sector.ceiling;
  const std::optional<Slope>& slope = isFloor ? sector.floorSlope : sector.ceilingSlope;
  const Vec2 gradient = slope ? slope->gradient : Vec2{};
  const double scale = (isFloor ? 1 : -1) / std::sqrt(1 + dot(gradient, gradient));
  SurfaceKind kind = isFloor ? SurfaceKind::Floor : SurfaceKind::Ceiling;
  if (slope) kind = isFloor ? SurfaceKind::SlopeFloor : SurfaceKind::SlopeCeiling;
  if (flat.isSky) kind = isFloor ? SurfaceKind::SkyFloor : SurfaceKind::SkyCeiling;

  TruthHit found;
  found.kind = kind;
  found.sector = id;
  found.point = ray.at(t);
  found.normal = scale * Vec3{-gradient.x, -gradient.y, 1};
  found.t = t;
  found.texture = flat.texture;
  found.imageMetres = flat.isSky ? skyImageMetres(ray.direction, *flat.texture, isFloor)
                                 : found.point.xy() - flat.textureOrigin;
  return found;
}

std::variant<TruthHit, Stage> throughWall(const Level& level, const Ray& ray, SegmentId segment,
                                          double t) {
  const std::variant<TruthHit, PortalCrossing> met = meetWall(level, ray, segment, t);
  if (const TruthHit* hit = std::get_if<TruthHit>(&met)) return *hit;
  const PortalCrossing& crossing = std::get<PortalCrossing>(met);
  return Stage{crossing.next, t, crossing.twin};
}

/// Whether the ray is in the sector's outline at `place`: from there on it leaves it once more
/// often than it enters it. Consistent with `findExit` also where the place, rounded, is on a wall.
bool holds(const Level& level, const Ray& ray, SectorId sector, Vec2 place) {
  int leaves = 0;
  for (const Segment& segment : level.segmentsOf(level[sector])) {
    const bool isFront = isRight(ray, segment.p1);
    if (isFront == isRight(ray, segment.p0)) continue;
    const int side = orientation(segment.p0, segment.p1, place);
    if (isFront && side >= 0) ++leaves;
    if (!isFront && side < 0) --leaves;
  }
  return leaves == 1;
}

/// The sector on the other side of a flat portal.
SectorId sectorAcross(const Level& level, const Ray& ray, const FlatPortal& flatPortal,
                      FlatPortalSide to, Vec2 place) {
  for (const SectorId member : flatPortal.members(to))
    if (holds(level, ray, member, place)) return member;
  // Vertical rays, and gaps between sectors that the author's tolerance allows.
  return sectorAcross(level, flatPortal, to, place);
}

std::variant<TruthHit, Stage> throughFlat(const Level& level, const Ray& ray, SectorId id,
                                          bool isFloor, double t) {
  const Sector& sector = level[id];
  const Flat& flat = isFloor ? sector.floor : sector.ceiling;
  if (!flat.flatPortal) return flatHit(ray, id, sector, isFloor, t);
  const Vec2 place = ray.at(t).xy();
  const FlatPortalSide to = isFloor ? FlatPortalSide::Lower : FlatPortalSide::Upper;
  return Stage{sectorAcross(level, ray, level[*flat.flatPortal], to, place), t, place};
}

/// The surface that the ray meets first, or the sector in which it is at `tEnd`: with kNever, the
/// sky sector through which light leaves the level.
std::variant<TruthHit, SectorId> follow(const Level& level, SectorId sector, const Ray& ray,
                                        double tEnd, const MeetInAir& meetInAir = {}) {
  Stage stage{sector, 0, {}};
  for (int step = 0; step < kMaxSteps; ++step) {
    const std::optional<SegmentId> exit = findExit(level, ray, stage);
    const double tWall = exit ? crossingOf(ray, level[*exit]) : kNever;
    const double tFloor = meetFlat(ray, level[stage.sector], true);
    const double tCeiling = meetFlat(ray, level[stage.sector], false);
    const double tFirst = std::min({tWall, tFloor, tCeiling});
    const double t = std::max(tFirst, stage.t);  // what was behind us by rounding is here
    if (meetInAir)
      if (const auto met = meetInAir({stage.sector, stage.t, std::min(t, tEnd)})) return *met;
    if (tFirst >= tEnd) return stage.sector;

    const auto next = tFirst == tWall ? throughWall(level, ray, *exit, t)
                                      : throughFlat(level, ray, stage.sector, tFirst == tFloor, t);
    if (const TruthHit* hit = std::get_if<TruthHit>(&next)) return *hit;
    stage = std::get<Stage>(next);
  }
  checkFailed(__FILE__, __LINE__, "a ray ends", level[sector].name);
}

}  // namespace

std::optional<TruthHit> trace(const Level& level, SectorId sector, Vec3 origin, Vec3 direction,
                              RayKind kind) {
  const auto end = follow(level, sector, makeRay(origin, direction, kind), kNever);
  if (const TruthHit* hit = std::get_if<TruthHit>(&end)) return *hit;
  CHECK(kind == RayKind::Light, level[std::get<SectorId>(end)].name);
  return std::nullopt;
}

TruthHit traceLook(const Level& level, SectorId sector, Vec3 origin, Vec3 direction,
                   const MeetInAir& meetInAir) {
  const Ray ray = makeRay(origin, direction, RayKind::Look);
  return std::get<TruthHit>(follow(level, sector, ray, kNever, meetInAir));
}

TruthHit traceGather(const Level& level, SectorId sector, Vec3 origin, Vec3 direction,
                     const MeetInAir& meetInAir) {
  const Ray ray = makeRay(origin, direction, RayKind::Gather);
  return std::get<TruthHit>(follow(level, sector, ray, kNever, meetInAir));
}

std::optional<TruthHit> traceLight(const Level& level, SectorId sector, Vec3 origin,
                                   const SurfacePoint& to, const MeetInAir& meetInAir) {
  Ray ray = makeRay(origin, to.point - origin, RayKind::Light);
  if (to.kind == SurfaceKind::MaskedMiddle) ray.litMaskedMiddle = to.segment;
  const auto end = follow(level, sector, ray, kNever, meetInAir);
  const TruthHit* hit = std::get_if<TruthHit>(&end);
  return hit ? std::optional(*hit) : std::nullopt;
}

std::variant<TruthHit, SectorId> traceLightToMesh(const Level& level, SectorId sector, Vec3 origin,
                                                  Vec3 end, const MeetInAir& meetInAir) {
  const Ray ray = makeRay(origin, end - origin, RayKind::Light);
  return follow(level, sector, ray, 1 - kArrival / length(ray.direction), meetInAir);
}

std::optional<SectorId> sectorAt(const Level& level, SectorId sector, Vec3 origin, Vec3 end,
                                 const MeetInAir& meetInAir) {
  const Ray ray = makeRay(origin, end - origin, RayKind::Light);
  const auto arrived = follow(level, sector, ray, 1, meetInAir);
  const SectorId* there = std::get_if<SectorId>(&arrived);
  return there ? std::optional(*there) : std::nullopt;
}

bool isSameSurface(const SurfacePoint& a, const SurfacePoint& b) {
  return a.kind == b.kind && a.sector == b.sector && a.segment == b.segment &&
         a.sprite == b.sprite && a.mesh == b.mesh && a.face == b.face;
}

}  // namespace hearth
