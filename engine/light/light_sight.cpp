#include "light/light_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "light/lit_lattice.h"
#include "math/planted_bug.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr int kPointsPerSample = 32;

/// Radii. Nearer to the middle of a ball than this, the directions in which it is seen fill too
/// much of a half-space to be a disc.
constexpr double kLeastDistance = 1.25;

/// The plane of a wall, through which nothing shines.
Plane planeOf(const Segment& segment) {
  const Vec2 along = (1 / segment.length) * (segment.p1 - segment.p0);
  return {{segment.p0.x, segment.p0.y, 0}, {-along.y, along.x, 0}};
}

Plane planeOf(const Flat& flat, const std::optional<Slope>& slope, bool isFloor) {
  const Vec2 gradient = slope ? slope->gradient : Vec2{};
  const double z = slope ? slope->zAt({0, 0}) : flat.z;
  const double scale = (isFloor ? 1 : -1) / std::sqrt(1 + dot(gradient, gradient));
  return {{0, 0, z}, scale * Vec3{-gradient.x, -gradient.y, 1}};
}

/// The planes of all walls, flats and slopes of the sector that come into the ball. Skies do not.
std::vector<Plane> planesInside(const Level& level, const Sector& sector, Vec3 middle,
                                double radius) {
  std::vector<Plane> planes;
  for (const Segment& segment : level.segmentsOf(sector))
    if (length(nearestOnSegment(segment.p0, segment.p1, middle.xy()) - middle.xy()) <= radius)
      planes.push_back(planeOf(segment));
  const auto addFlat = [&](const Flat& flat, const std::optional<Slope>& slope, bool isFloor) {
    const Plane plane = planeOf(flat, slope, isFloor);
    if (!flat.parallax && std::abs(plane.inFront(middle)) <= radius) planes.push_back(plane);
  };
  addFlat(sector.floor, sector.floorSlope, true);
  addFlat(sector.ceiling, sector.ceilingSlope, false);
  return planes;
}

/// The i-th point of a sequence that fills the cube [-1, 1)^3 evenly. Its steps are the powers of
/// 1/g, g = 1.2207... being the root of g^4 = g + 1 (M. Roberts, "The Unreasonable Effectiveness of
/// Quasirandom Sequences", 2018).
Vec3 spreadPoint(int i) {
  constexpr std::array kSteps = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  const auto coordinate = [i](double step) {
    const double x = 0.5 + i * step;
    return 2 * (x - std::floor(x)) - 1;
  };
  return {coordinate(kSteps[0]), coordinate(kSteps[1]), coordinate(kSteps[2])};
}

/// The directions from a point in which it would see a ball, as a disc of radius 1.
class BallDisc {
 public:
  /// Of the ball, what lies in front of all planes shines.
  BallDisc(Vec3 eye, Vec3 middle, double radius, const std::vector<Plane>& planes)
      : eye_(eye), planes_(planes), distance_(length(middle - eye)), radius_(radius) {
    forward_ = (1 / distance_) * (middle - eye);
    const Vec3 other = std::abs(forward_.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 right = cross(forward_, other);
    right_ = (1 / length(right)) * right;
    up_ = cross(right_, forward_);
    tangent_ = radius / std::sqrt((distance_ - radius) * (distance_ + radius));
  }

  /// What a line through a point of the disc has inside the ball, as distances from the eye.
  struct Chord {
    double from;
    double to;  ///< less than `from` where there is nothing
  };

  Chord wholeChord(Vec2 p) const {
    const double middle = distance_ / std::sqrt(length2(p));
    const double half2 = radius_ * radius_ - (distance_ - middle) * (distance_ + middle);
    const double half = std::sqrt(std::max(0.0, half2));
    return {middle - half, middle + half};
  }

  Chord shiningChord(Vec2 p) const {
    Chord chord = wholeChord(p);
    const Vec3 way = wayTo(p);
    for (const Plane& plane : planes_) {
      const double speed = dot(way, plane.normal);
      const double crossing = -plane.inFront(eye_) / speed;
      if (speed > 0) chord.from = std::max(chord.from, crossing);
      if (speed < 0) chord.to = std::min(chord.to, crossing);
    }
    return chord;
  }

  Vec3 pointAt(Vec2 p, double distance) const { return eye_ + distance * wayTo(p); }

  /// Volume of the ball along a line, for each share of the disc's area; up to a factor. A unit of
  /// solid angle has (to^3 - from^3) / 3 of it, and a unit of the disc 1 / length^3 of solid angle.
  double volumeOf(Chord chord, Vec2 p) const {
    if (chord.to <= chord.from) return 0;
    const double cubes = chord.to * chord.to * chord.to - chord.from * chord.from * chord.from;
    return cubes / (length2(p) * std::sqrt(length2(p)));
  }

 private:
  /// Of the way from the eye to a point of the disc 1 m before it.
  double length2(Vec2 p) const { return 1 + tangent_ * tangent_ * dot(p, p); }
  Vec3 wayTo(Vec2 p) const {
    const Vec3 way = forward_ + (tangent_ * p.x) * right_ + (tangent_ * p.y) * up_;
    return (1 / std::sqrt(length2(p))) * way;
  }

  Vec3 eye_;
  const std::vector<Plane>& planes_;
  double distance_;
  double radius_;
  Vec3 forward_;  ///< unit vectors
  Vec3 right_;
  Vec3 up_;
  double tangent_;  ///< of half the angle that the ball fills
};

}  // namespace

LightSight::LightSight(const Level& level, const LightSource& light, int softSamples)
    : raytracer_(level),
      middle_(Raytracer::sourceOf(level, light)),
      radius_(planted(PlantedBug::RadiusIgnored) ? 0 : light.radius),
      cells_(static_cast<int>(std::lround(std::sqrt(softSamples)))) {
  if (radius_ == 0) return;
  planes_ = planesInside(level, level[middle_.sector], middle_.position, radius_);
  isCutByPlanes_ = true;
  for (int i = 0; pointCount_ < kPointsPerSample * softSamples; ++i) {
    const Vec3 p = spreadPoint(i);
    if (dot(p, p) > 1) continue;
    ++pointCount_;
    const Vec3 position = middle_.position + radius_ * p;
    const std::optional<SectorId> sector = raytracer_.sectorAt(middle_, position);
    if (sector) points_.push_back({position, *sector});
    isCutByPlanes_ &= isBeforePlanes(position) == (sector == middle_.sector);
    isCutByPlanes_ &= !sector || sector == middle_.sector;
  }
}

bool LightSight::isBeforePlanes(Vec3 p) const {
  return std::ranges::all_of(planes_, [p](const Plane& plane) { return plane.inFront(p) > 0; });
}

double LightSight::seenShare(const LightTarget& target, std::int64_t& rays) const {
  if (radius_ == 0) return ++rays, raytracer_.sees(middle_, target.point, target.sector) ? 1 : 0;
  const bool isNear = length(middle_.position - target.point) < kLeastDistance * radius_;
  return isNear || !isCutByPlanes_ ? seenOfPoints(target, rays) : seenOfDisc(target, rays);
}

bool LightSight::sees(const LightTarget& target, const Raytracer::Source& source) const {
  return target.plane.inFront(source.position) > kInPlane &&
         raytracer_.sees(source, target.point, target.sector);
}

double LightSight::seenOfPoints(const LightTarget& target, std::int64_t& rays) const {
  rays += std::ssize(points_);
  const auto seen = std::ranges::count_if(
      points_, [&](const Raytracer::Source& point) { return sees(target, point); });
  return static_cast<double>(seen) / pointCount_;
}

double LightSight::seenOfDisc(const LightTarget& target, std::int64_t& rays) const {
  const BallDisc disc(target.point, middle_.position, radius_, planes_);
  const double cellSize = 2.0 / cells_;
  const auto onDisc = [&](Vec2 cells) { return cellSize * cells - Vec2{1, 1}; };
  const LitLattice lattice(cells_, cells_, [&](Vec2 corner) {
    const Vec2 p = (1 / std::max(1.0, length(onDisc(corner)))) * onDisc(corner);
    const auto [from, to] = disc.shiningChord(p);
    return from <= to && sees(target, {disc.pointAt(p, (from + to) / 2), middle_.sector});
  });
  rays += lattice.questions();
  if (lattice.isUniform() && !lattice.isLitAt(0, 0)) return 0;
  if (lattice.isUniform() && planes_.empty()) return 1;
  double seen = 0;
  double whole = 0;
  for (int j = 0; j < cells_; ++j)
    for (int i = 0; i < cells_; ++i) {
      const Vec2 cell{static_cast<double>(i), static_cast<double>(j)};
      const double all = kWholeCell.integral([&](Vec2 inCell) {
        const Vec2 p = onDisc(cell + inCell);
        return disc.volumeOf(disc.wholeChord(p), p);
      });
      const bool isAllSeen = lattice.litCorners(i, j) == 4 && planes_.empty();
      whole += all;
      seen += isAllSeen ? all : lattice.part(i, j).integral([&](Vec2 inCell) {
        const Vec2 p = onDisc(cell + inCell);
        return disc.volumeOf(disc.shiningChord(p), p);
      });
    }
  return seen / whole;
}

LightSights::LightSights(const Level& level, int softSamples) {
  for (const LightSource& light : level.lights) {
    fine.emplace_back(level, light, softSamples);
    rough.emplace_back(level, light, std::max(1, softSamples / 4));
  }
}

}  // namespace hearth
