#include "light/baking/sun_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "level/locate.h"
#include "light/grid/lit_lattice.h"
#include "math/box3.h"
#include "math/disc_area.h"
#include "math/tolerance.h"
#include "math/trig.h"

namespace hearth {

namespace {

/// Around the air of all sectors.
Box3 boxOfAir(const Scene& scene) {
  Box3 box;
  for (const Sector& sector : scene.level().sectors)
    for (const Segment& segment : scene.segmentsOf(sector)) {
      const AirColumn air = scene.airAt(segment, 0);
      box.add(Vec3{segment.p0.x, segment.p0.y, air.zBottom});
      box.add(Vec3{segment.p0.x, segment.p0.y, air.zTop});
    }
  return box;
}

/// Of rays to points of a disc of radius 1 that are no farther than the square root of 2 from its
/// middle.
SunCone coneOf(const Scene& scene, const Sun& sun, double squaredRim) {
  const Box3 air = boxOfAir(scene);
  // Of things that reach a little out of the air, too.
  const double reach = 2 * length(air.max - air.min) + 1;
  const double cosine = 1 - squaredRim;
  return {sun.direction(), std::sqrt(1 - cosine * cosine), cosine, reach, air.max.z};
}

}  // namespace

SunVisibility::SunVisibility(const Scene& scene, const Sun& sun, int softSamples,
                             bool solidMaskedMiddles)
    : scene_(scene),
      raytracer_(scene, solidMaskedMiddles),
      sinRim_(softSamples == 0 ? 0 : sun.sinRadius()),
      squaredRim_(softSamples == 0 ? 0 : 2 * (1 - sun.cosRadius())),
      cone_(coneOf(scene, sun, squaredRim_)),
      cells_(sinRim_ > 0 ? static_cast<int>(std::lround(std::sqrt(softSamples))) : 0),
      right_(directionAt(sun.angle() - 90, 0)),
      up_(cross(right_, cone_.direction)) {}

/// Towards a point of the disc, of radius 1. Equal areas of the disc are equal solid angles
/// (Lambert's azimuthal projection): what is an angle a away from the middle is 2 sin(a / 2) away
/// on it, with that of the rim as the unit.
Vec3 SunVisibility::directionTo(Vec2 p) const {
  // With k = (2 sin(a / 2))^2, cos a = 1 - k / 2 and sin a = sqrt(k) sqrt(1 - k / 4).
  const double k = dot(p, p) * squaredRim_;
  const double sideways = std::sqrt(squaredRim_ * (1 - k / 4));
  return (1 - k / 2) * cone_.direction + sideways * p.x * right_ + sideways * p.y * up_;
}

/// `sees` answers whether a ray towards the disc ends in the sky.
template <typename Sees>
double SunVisibility::seenFractionBy(Sees&& sees) const {
  if (cells_ == 0) return sees(cone_.direction) ? 1 : 0;
  const auto onDisc = [this](Vec2 cells) { return 2.0 / cells_ * cells - Vec2{1, 1}; };
  const auto isLit = [&](Vec2 cells) { return sees(directionTo(onDisc(cells))); };
  const LitLattice lattice(cells_, cells_, isLit);
  if (lattice.isUniform()) return lattice.isLitAt(0, 0) ? 1 : 0;
  double area = 0;
  for (int j = 0; j < cells_; ++j)
    for (int i = 0; i < cells_; ++i) {
      LitPart part = lattice.part(i, j);
      for (Vec2& p : std::span(part.points).first(part.count))
        p = onDisc(Vec2{1.0 * i, 1.0 * j} + p);
      area += areaInUnitDisc(std::span<const Vec2>(part.points).first(part.count));
    }
  return std::clamp(area / std::numbers::pi, 0.0, 1.0);
}

double SunVisibility::seenFraction(const LightTarget& target, std::int64_t& rays,
                                   SectorSet* met) const {
  return seenFractionBy([&](Vec3 direction) {
    if (dot(target.plane.normal, direction) <= kInPlaneSine) return false;
    ++rays;
    return raytracer_.seesSky({target.point, target.sector}, direction, met);
  });
}

double SunVisibility::seenFraction(const LightTarget& target, const SkyShaft& shaft,
                                   TargetVisibility outcome, std::int64_t& rays) const {
  if (outcome == TargetVisibility::Dark) return 0;
  if (outcome == TargetVisibility::Lit) return fractionInFront(target.plane.normal);
  return seenFractionBy([&](Vec3 direction) {
    if (dot(target.plane.normal, direction) <= kInPlaneSine) return false;
    ++rays;
    return raytracer_.seesSky({target.point, target.sector}, direction, shaft);
  });
}

double SunVisibility::seenFractionFromAir(Vec3 point, SectorId sector, std::int64_t& rays) const {
  return seenFractionBy([&](Vec3 direction) {
    ++rays;
    return raytracer_.seesSky({point, sector}, direction);
  });
}

double SunVisibility::seenFraction(const FacePoint& target, SectorId sector, const SkyShaft& shaft,
                                   std::int64_t& rays) const {
  const Raytracer::Source start = startAt(target.point, sector);
  return seenFractionBy([&](Vec3 direction) {
    if (dot(target.normal, direction) <= kInPlaneSine) return false;
    ++rays;
    return raytracer_.seesSky(start, target, direction, shaft);
  });
}

double SunVisibility::seenFractionFromCorner(Vec3 corner, std::uint32_t mesh, SectorId sector,
                                             const SkyShaft& shaft, std::int64_t& rays) const {
  const FacePoint target{corner, cone_.direction, mesh};
  const Raytracer::Source start = startAt(corner, sector);
  return seenFractionBy([&](Vec3 direction) {
    ++rays;
    return raytracer_.seesSky(start, target, direction, shaft);
  });
}

/// A point of a mesh may lie in the plane of a wall.
Raytracer::Source SunVisibility::startAt(Vec3 point, SectorId sector) const {
  return {nudgedInside(scene_, scene_[sector], point), sector};
}

double SunVisibility::fractionInFront(Vec3 normal) const {
  const double height = dot(normal, cone_.direction);
  if (cells_ == 0) return height > kInPlaneSine ? 1 : 0;
  // The plane cuts off a segment of the disc.
  const double h = std::clamp(height / sinRim_, -1.0, 1.0);
  if (h == 1) return 1;
  std::array<Vec2, 4> inFront{Vec2{2, -h}, Vec2{2, 2}, Vec2{-2, 2}, Vec2{-2, -h}};
  return areaInUnitDisc(inFront) / std::numbers::pi;
}

}  // namespace hearth
