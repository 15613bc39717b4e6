#include <algorithm>
#include <cmath>

#include "level/locate.h"
#include "math/tolerance.h"
#include "walk/surroundings.h"
#include "walk/walker.h"

namespace hearth {

Eye eyeOf(const Scene& scene, const Walker& walker) {
  Eye eye{walker.sector, walker.feet, walker.angle, walker.pitch};
  const Vec2 p = walker.feet.xy();
  eye.point.z += bodyOf(scene.level(), walker.crouch).eyeHeight;
  while (scene[eye.sector].ceiling.flatPortal && eye.point.z > scene.zCeiling(scene[eye.sector]))
    eye.sector = sectorAcross(scene.level(), scene[*scene[eye.sector].ceiling.flatPortal],
                              FlatPortalSide::Upper, p);
  eye.point.z = std::min(eye.point.z, std::max(walker.feet.z, scene.airTop(scene[eye.sector], p)));
  return eye;
}

Eye eyeBetween(const Scene& scene, const Walker& before, const Walker& after, double fraction) {
  const Eye from = eyeOf(scene, before);
  const Eye to = eyeOf(scene, after);
  const double turn = std::remainder(to.angle - from.angle, 360.0);
  Eye eye = fraction < 0.5 ? from : to;
  eye.angle = std::fmod(from.angle + fraction * turn + 360, 360.0);
  eye.pitch = std::lerp(from.pitch, to.pitch, fraction);

  const Vec3 point = from.point + fraction * (to.point - from.point);
  const double travel = length(to.point.xy() - from.point.xy());
  const double climb = std::abs(after.feet.z - before.feet.z);
  const Body body = bodyOf(scene.level(), before.crouch);
  const SweepQuery query{before.feet.xy(),
                         body.radius + kSkin,
                         travel,
                         {before.feet.z, before.feet.z + climb, body.height},
                         before.feet.z - climb,
                         before.feet.z + climb + body.height};
  const Surroundings around(scene, before.sector, query);
  const auto isAt = [&](SectorId sector) {
    return contains(scene, scene[sector], point, kPositionSlack);
  };
  std::optional<SectorId> found;
  if (isAt(to.sector)) found = to.sector;
  if (isAt(from.sector)) found = from.sector;
  for (const SectorId sector : around.sectors())
    if (!found && isAt(sector)) found = sector;
  // Without a body the straight line between two eyes can cut a corner: then it is the nearer eye.
  if (!found) return eye;
  eye.sector = *found;
  eye.point = point;
  return eye;
}

}  // namespace hearth
