#include "light/rays/target_air.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "light/ray_error.h"

namespace hearth {

bool isAirClear(const Scene& scene, const Sector& sector, const TargetRays& rays,
                std::span<const Vec3> points) {
  const double least = minInFront(rays.noise, rays.reach);
  const bool isLevel = !sector.floorSlope && !sector.ceilingSlope;
  const auto isClearOf = [&](const std::optional<Slope>& slope, auto&& inFront) {
    const double steepness = slope ? length(slope->gradient) : 0;
    const double ofLight = inFront(rays.light);
    const double radius = (1 + steepness) * rays.radius;
    // Where nothing leans, surfaces and openings lie between the flats: rays from behind one are
    // stopped before they come in, or have passed its height by then.
    if (isLevel && std::abs(ofLight) - radius >= least) return true;
    return std::ranges::all_of(points, [&](Vec3 p) {
      const double ofPoint = inFront(p);
      return ofPoint > rays.margin || (ofPoint >= -rays.noise && ofLight - radius >= least);
    });
  };
  return (sector.floor.isSky ||
          isClearOf(sector.floorSlope,
                    [&](Vec3 p) { return p.z - scene.airBottom(sector, p.xy()); })) &&
         (sector.ceiling.isSky || isClearOf(sector.ceilingSlope, [&](Vec3 p) {
            return scene.airTop(sector, p.xy()) - p.z;
          }));
}

}  // namespace hearth
