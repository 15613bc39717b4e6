#include "load/link/position_finder.h"

namespace hearth {

PositionFinder::PositionFinder(const Linking& linking)
    : linking_(linking), locator_(linking.scene()) {
  for (const bool isDoubtful : linking.isDoubtful) anyDoubtful_ |= isDoubtful;
}

std::optional<SectorId> PositionFinder::find(Place place, Vec3 p,
                                             const std::optional<NameReference>& name,
                                             PositionOf what) const {
  return find(place, name,
              [&](std::optional<SectorId> sector) { return locator_.locate(p, sector, what); });
}

std::optional<PositionFinder::Standing> PositionFinder::find(const ThingDescription& thing) const {
  const Vec2 xy = thing.position;
  const auto sector = find(thing.place, thing.sector, [&](std::optional<SectorId> named) {
    return thing.z ? locator_.locate({xy.x, xy.y, *thing.z}, named, PositionOf::Camera)
                   : locator_.locateOnFloor(xy, named);
  });
  if (!sector) return std::nullopt;
  const double z = thing.z.value_or(linking_.scene().airBottom(linking_.level[*sector], xy));
  return Standing{*sector, {xy.x, xy.y, z}};
}

/// `locate(sector)` looks in the sector that the author names, or in all.
template <typename Locate>
std::optional<SectorId> PositionFinder::find(Place place, const std::optional<NameReference>& name,
                                             Locate&& locate) const {
  std::optional<SectorId> sector;
  if (name) {
    sector = linking_.names.link(linking_.report, *name);
    if (!sector) return std::nullopt;
  }
  // It may be in a sector about which a mistake has been reported.
  if (sector ? linking_.isDoubtful[sector->index()] : anyDoubtful_) return std::nullopt;
  if (linking_.report.isFull()) return std::nullopt;
  const auto found = locate(sector);
  if (found) return *found;
  linking_.report.error(place, found.error().message, found.error().advice);
  return std::nullopt;
}

}  // namespace hearth
