#include "light/rays/sky_shaft.h"

#include <algorithm>
#include <cmath>

#include "light/grid/slope_reach.h"
#include "light/rays/passage.h"
#include "math/check.h"

namespace hearth {

TargetVisibility SkyShaft::follow(const SunCone& sun, const ShaftTargets& targets,
                                  const SkyShaft* within) {
  within_ = within;
  sun_ = &sun;
  hull_.emplace(sun, targets.box);
  walls_.clear();
  meshes_.clear();
  sectors_.clear();
  arrives_ = isStopped_ = false;
  for (const SectorId sector : targets.sectors) enter(sector);
  for (std::size_t i = 0; i < sectors_.size(); ++i) visit(i);
  if (!arrives_) return TargetVisibility::Dark;
  return isStopped_ || !meshes_.empty() ? TargetVisibility::Unknown : TargetVisibility::Lit;
}

const SkyShaft::MetSector* SkyShaft::find(SectorId id) const {
  const auto found = std::ranges::find(sectors_, id, &MetSector::id);
  return found == sectors_.end() ? nullptr : &*found;
}

std::span<const Segment* const> SkyShaft::wallsIn(SectorId id) const {
  const MetSector* sector = find(id);
  CHECK(sector, id);
  return std::span(walls_).subspan(sector->begin, sector->end - sector->begin);
}

std::span<const MeshInSector> SkyShaft::meshesIn(SectorId id) const {
  const MetSector* sector = find(id);
  CHECK(sector, id);
  return std::span(meshes_).subspan(sector->meshesBegin, sector->meshesEnd - sector->meshesBegin);
}

void SkyShaft::enter(SectorId id) {
  if (find(id) || (within_ && !within_->find(id))) return;
  sectors_.push_back({id, 0, 0, 0, 0});
}

void SkyShaft::visit(std::size_t index) {
  const auto sizeOf = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  const SectorId id = sectors_[index].id;
  MetSector met{id, sizeOf(walls_), 0, sizeOf(meshes_), 0};
  meetWalls(scene_[id]);
  meetFlats(scene_[id]);
  meetMeshes(id);
  met.end = sizeOf(walls_);
  met.meshesEnd = sizeOf(meshes_);
  sectors_[index] = met;
}

void SkyShaft::meetWalls(const Sector& sector) {
  if (within_)
    for (const Segment* wall : within_->wallsIn(sector.id)) meetWall(sector, *wall);
  else
    hull_->forEachWallNear(scene_.level(), sector, near_,
                           [&](const Segment& wall) { meetWall(sector, wall); });
}

/// Whether no ray can leave the sector through a wall, which the hull may touch nevertheless.
bool SkyShaft::isHarmless(const Segment& wall) const {
  const Vec2 normal = (1 / wall.length) * turned90(wall.p1 - wall.p0);
  const double towardsFront = dot(normal, sun_->direction.xy());
  // Which way a ray crosses a wall must not be left to rounding.
  const double inLine = sun_->sinRadius + hull_->noise() * (1 + 1 / wall.length);
  return towardsFront > inLine ||
         (towardsFront < -inLine &&
          hull_->distances(wall.p0, normal).maxOfTargets < -hull_->margin());
}

void SkyShaft::meetWall(const Sector& sector, const Segment& wall) {
  if (isHarmless(wall)) return;
  const std::optional<ShaftHull::Slice> slice = hull_->slice(wall.p0, wall.p1);
  if (!slice) return;
  walls_.push_back(&wall);
  // A ray that crosses this wall lower than the sky has not ended there before.
  const AirLines air = airAlong(scene_, wall, slice->from, slice->to);
  if (sector.ceiling.isSky) arrives_ |= !slice->isBelow(air.top);
  if (haveLeftBefore(scene_, sector, wall, *slice, SkyIs::TheEnd)) return;
  bool stops = true;
  for (const LightOpening& opening : scene_.lightOpeningsOf(wall)) {
    const ShaftPassage passage =
        passageThrough(scene_, sector, wall, opening, *slice, SkyIs::TheEnd);
    if (!passage.isShut) enter(opening.next);
    if (passage.isOpen) stops = false;
  }
  isStopped_ |= stops;
}

/// All rays cross walls in the end, which tell whether they come too high or too low before:
/// except upright ones, and those that end in a step between two skies, or go down.
void SkyShaft::meetFlats(const Sector& sector) {
  const bool isUpright = sun_->isUpright();
  if (sector.ceiling.isSky) arrives_ |= isUpright || !sun_->goesUp();
  if (sector.floor.isSky) arrives_ = true;
  if (isUpright) isStopped_ |= !sector.ceiling.isSky && !sector.ceiling.flatPortal;
  const auto [zFloor, zCeiling] = scene_.geometryOf(sector);
  if (sector.floor.flatPortal && hull_->zMin() < zFloor)
    goThroughFlat(sector, scene_[*sector.floor.flatPortal].lower, zFloor);
  if (sector.ceiling.flatPortal && hull_->zMax() > zCeiling)
    goThroughFlat(sector, scene_[*sector.ceiling.flatPortal].upper, zCeiling);
}

/// A slope may come through the plane of a flat portal, and stop rays there.
void SkyShaft::goThroughFlat(const Sector& sector, const std::vector<SectorId>& members, double z) {
  isStopped_ |= hasSlopeAt(scene_, sector, z);
  for (const SectorId member : members) {
    isStopped_ |= hasSlopeAt(scene_, scene_[member], z);
    enter(member);
  }
}

void SkyShaft::meetMeshes(SectorId id) {
  const std::span<const MeshInSector> all =
      within_ ? within_->meshesIn(id) : scene_.level().meshesIn(id);
  for (const MeshInSector& at : all)
    if (hull_->mayMeet(scene_.level(), at.mesh)) meshes_.push_back(at);
}

}  // namespace hearth
