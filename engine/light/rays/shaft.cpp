#include "light/rays/shaft.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "light/grid/slope_reach.h"
#include "light/ray_error.h"
#include "light/rays/passage.h"
#include "light/rays/target_air.h"
#include "math/check.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

TargetVisibility Shaft::follow(const ShaftLight& light, const ShaftTargets& targets,
                               const Shaft* within) {
  light_ = &light;
  targets_ = &targets;
  within_ = within;
  hull_.emplace(light.center, light.radius, targets.box);
  minInFront_ = minInFront(hull_->noise(), hull_->reach());
  mets_.clear();
  walls_.clear();
  meshes_.clear();
  exits_.clear();
  sectors_.clear();
  visits_.clear();
  faces_.clear();
  areFacesKnown_ = isOpenButForFaces_ = arrives_ = isStopped_ = false;
  gate_ = within ? within->gate() : std::nullopt;
  bool isGated = gate_ || light.sectors.size() == 1;
  if (gate_)
    goThroughGate();
  else
    for (const SectorId sector : light.sectors) go({sector, Entry::FromLight, nullptr, {}, {}});
  for (std::size_t i = 0; i < visits_.size(); ++i) {
    const Visit entered = visits_[i];
    visit(entered);
    if (!isGated) continue;
    const std::optional<Gate> gate = gateOf(entered);
    isGated = gate && i + 2 == visits_.size();
    if (isGated) gate_ = gate;
  }
  if (!arrives_) return TargetVisibility::Dark;
  isOpenButForFaces_ = !isStopped_ && targets.sectors.size() == 1 && areTargetsClear();
  // From a ball many rays go to each target, and from a point one, not worth a search.
  const bool areMany = light.radius > 0 && (isOpenButForFaces_ || targets.box.count == 1);
  areFacesKnown_ = meshes_.empty() || (areMany && findFaces());
  return isOpenButForFaces_ && areFacesKnown_ && faces_.empty() ? TargetVisibility::Lit
                                                                : TargetVisibility::Unknown;
}

bool Shaft::meets(SectorId id) const {
  return std::ranges::any_of(sectors_, [id](const MetSector& sector) { return sector.id == id; });
}

std::span<const Segment* const> Shaft::wallsIn(SectorId id) const {
  for (const MetSector& sector : sectors_)
    if (sector.id == id) return std::span(walls_).subspan(sector.begin, sector.end - sector.begin);
  CHECK(false, id);
  return {};
}

std::span<const MeshInSector> Shaft::meshesIn(SectorId id) const {
  for (const MetSector& sector : sectors_)
    if (sector.id == id)
      return std::span(meshes_).subspan(sector.meshesBegin, sector.meshesEnd - sector.meshesBegin);
  CHECK(false, id);
  return {};
}

bool Shaft::isTarget(SectorId id) const {
  return std::ranges::find(targets_->sectors, id) != targets_->sectors.end();
}

const Shaft::MetSector& Shaft::meet(SectorId id) {
  for (const MetSector& sector : sectors_)
    if (sector.id == id) return sector;
  const auto count = [&] { return static_cast<std::uint32_t>(mets_.size()); };
  MetSector met{id, count(), 0, 0, 0, 0};
  const Sector& sector = scene_[id];
  if (within_)
    for (const Segment* wall : within_->wallsIn(id)) meetWall(sector, id, *wall);
  else
    hull_->forEachWallNear(scene_.level(), sector, near_,
                           [&](const Segment& wall) { meetWall(sector, id, wall); });
  met.end = count();
  meetMeshes(met);
  findScreens(met);
  return sectors_.emplace_back(met);
}

void Shaft::meetMeshes(MetSector& sector) {
  sector.meshesBegin = static_cast<std::uint32_t>(meshes_.size());
  const std::span<const MeshInSector> all =
      within_ ? within_->meshesIn(sector.id) : scene_.level().meshesIn(sector.id);
  for (const MeshInSector& at : all)
    if (hull_->mayMeet(scene_.level(), at.mesh)) meshes_.push_back(at);
  sector.meshesEnd = static_cast<std::uint32_t>(meshes_.size());
}

/// Finds the faces that rays may meet. False if they are many.
bool Shaft::findFaces() {
  for (auto at = meshes_.begin(); at != meshes_.end(); ++at) {
    const auto isSame = [&](const MeshInSector& other) { return other.mesh == at->mesh; };
    if (std::find_if(meshes_.begin(), at, isSame) != at) continue;
    const auto sectors = static_cast<std::size_t>(std::ranges::count_if(meshes_, isSame));
    if (!addFacesOf(at->mesh, sectors == sectors_.size())) return false;
  }
  return true;
}

bool Shaft::addFacesOf(std::uint32_t mesh, bool stopsAll) {
  constexpr std::size_t kMostFaces = 32;  // that are tested sooner than the boxes around them
  const Level& level = scene_.level();
  const std::span<const MeshFace> faces = level.facesOf(level.meshes[mesh]);
  return !hull_->anyFaceMet(level, mesh, [&](std::uint32_t face) {
    if (faces_.size() == kMostFaces) return true;
    faces_.push_back({&faces[face], stopsAll});
    return false;
  });
}

/// Whether no ray can leave the sector through a wall, which the hull may touch nevertheless.
bool Shaft::isHarmless(SectorId id, const Segment& wall, const ShaftHull::Distances& d) const {
  const double margin = hull_->margin();
  if (d.minOfTargets > margin) {
    if (d.minOfLight >= 0) return true;
    if (light_->isCutByWalls && id == light_->sectors.front() &&
        length(nearestOnSegment(wall.p0, wall.p1, light_->center.xy()) - light_->center.xy()) <=
            light_->radius)
      return true;
  }
  // A ray from behind a wall goes through to its front. On which side the ray is must not be left
  // to rounding where the ray is in line with the wall, which is short seen from afar.
  const double reach = hull_->reach();
  return d.maxOfLight < -(margin + hull_->noise() * reach / wall.length);
}

void Shaft::meetWall(const Sector& sector, SectorId id, const Segment& wall) {
  const Vec2 normal = (1 / wall.length) * turned90(wall.p1 - wall.p0);
  const ShaftHull::Distances d = hull_->distances(wall.p0, normal);
  if (isHarmless(id, wall, d)) return;
  const std::optional<ShaftHull::Slice> slice = hull_->slice(wall.p0, wall.p1);
  if (!slice) return;
  Met met{.wall = &wall,
          .normal = normal,
          .start = lerp(wall.p0, wall.p1, slice->from),
          .end = lerp(wall.p0, wall.p1, slice->to),
          .startsInside = slice->from == 0,
          .endsInside = slice->to == 1,
          .minOfLight = d.minOfLight,
          .maxOfTargets = d.maxOfTargets,
          .stops = false,
          .firstExit = static_cast<std::uint32_t>(exits_.size()),
          .lastExit = 0,
          .screen = 0};
  // Rays that come from the front and end there, or on it, do not go through.
  const bool endsHere = targets_->sectors.size() == 1 && isTarget(id) &&
                        d.minOfLight >= minInFront_ && d.minOfTargets >= -hull_->noise();
  if (!endsHere) meetOpenings(sector, *slice, met);
  met.lastExit = static_cast<std::uint32_t>(exits_.size());
  mets_.push_back(met);
  walls_.push_back(&wall);
}

void Shaft::meetOpenings(const Sector& sector, const ShaftHull::Slice& slice, Met& met) {
  if (haveLeftBefore(scene_, sector, *met.wall, slice, SkyIs::Passed)) return;
  met.stops = true;
  for (const LightOpening& opening : scene_.lightOpeningsOf(*met.wall)) {
    const ShaftPassage passage =
        passageThrough(scene_, sector, *met.wall, opening, slice, SkyIs::Passed);
    if (!passage.isShut) exits_.push_back(&opening);
    if (passage.isOpen) met.stops = false;
  }
}

Shaft::Met* Shaft::nextInLoop(const MetSector& sector, const Met& met) {
  const Loop& loop = scene_[sector.id].loops[met.wall->loop];
  const Segment* first = &scene_[loop.first];
  const Segment* next = met.wall + 1 == first + loop.count ? first : met.wall + 1;
  for (Met& other : wallsOf(sector))
    if (other.wall == next) return &other;
  return nullptr;
}

void Shaft::findScreens(MetSector& sector) {
  for (Met& met : wallsOf(sector))
    if (!met.startsInside) findScreenFrom(sector, met);
}

/// From a wall that comes into the hull on to the one that leaves it.
///
/// A ray from a point in front of all their lines to one behind all of them goes through one of
/// them: seen across the ray, they follow one another to one side only. So if it passed beside the
/// screen it would cross, in the hull, the line of the first or last wall beyond the end of that:
/// which lies outside the hull, and yet between two points of it.
void Shaft::findScreenFrom(MetSector& sector, Met& first) {
  chain_.clear();
  for (Met* met = &first;; met = nextInLoop(sector, *met)) {
    if (!met || met->maxOfTargets >= -hull_->margin()) return;
    if (met != &first && !met->startsInside) return;
    chain_.push_back(static_cast<std::uint32_t>(met - mets_.data()));
    if (!met->endsInside) break;
    if (chain_.size() > sector.end - sector.begin) return;
  }
  ++sector.screens;
  for (const std::uint32_t index : chain_) mets_[index].screen = sector.screens;
}

void Shaft::go(const Visit& visit) {
  if (within_ && !within_->meets(visit.sector)) return;
  for (const Visit& other : visits_)
    if (other.sector == visit.sector && other.entry == visit.entry &&
        (visit.entry != Entry::ThroughWall || other.through->twin == visit.through->twin))
      return;
  visits_.push_back(visit);
}

/// All rays go through that of the shaft around this one, too, and nothing stops them before.
void Shaft::goThroughGate() {
  const Segment& wall = *gate_->wall;
  if (const std::optional<ShaftHull::Slice> slice = hull_->slice(wall.p0, wall.p1))
    go({gate_->opening->next, Entry::ThroughWall, gate_->opening,
        lerp(wall.p0, wall.p1, slice->from), lerp(wall.p0, wall.p1, slice->to)});
}

/// Whether a screen lies between the way into its sector and the targets.
bool Shaft::isScreen(const MetSector& sector, std::uint32_t screen, const Visit& visit) {
  if (visit.entry == Entry::ThroughFlat) return false;
  const double margin = hull_->margin();
  for (const Met& met : wallsOf(sector)) {
    if (met.screen != screen) continue;
    if (met.minOfLight <= margin) return false;
    if (visit.entry == Entry::ThroughWall &&
        (met.inFront(visit.start) <= margin || met.inFront(visit.end) <= margin))
      return false;
  }
  return true;
}

bool Shaft::isBehind(const MetSector& sector, std::uint32_t screen, const Met& met) {
  if (met.screen == screen) return false;
  const double margin = hull_->margin();
  return std::ranges::all_of(wallsOf(sector), [&](const Met& part) {
    return part.screen != screen ||
           (part.inFront(met.start) < -margin && part.inFront(met.end) < -margin);
  });
}

/// Whether one of the `screens_` of the visit at hand lies before a wall.
bool Shaft::isHidden(const MetSector& sector, const Met& met) {
  return std::ranges::any_of(screens_,
                             [&](std::uint32_t screen) { return isBehind(sector, screen, met); });
}

void Shaft::visit(const Visit& visit) {
  const MetSector sector = meet(visit.sector);
  screens_.clear();
  for (std::uint32_t screen = 1; screen <= sector.screens; ++screen)
    if (isScreen(sector, screen, visit)) screens_.push_back(screen);
  for (const Met& met : wallsOf(sector)) {
    if (isHidden(sector, met)) continue;
    isStopped_ |= met.stops;
    for (std::uint32_t i = met.firstExit; i < met.lastExit; ++i)
      go({exits_[i]->next, Entry::ThroughWall, exits_[i], met.start, met.end});
  }
  goThroughFlats(scene_[visit.sector]);
  if (!screens_.empty()) return;
  if (isTarget(visit.sector))
    arrives_ = true;
  else
    isStopped_ |= !endsOutside(scene_[visit.sector]);
}

/// The one wall that all rays leave a sector through, having come into it by a way that has just
/// been visited; none where some may leave it elsewhere, or stop.
std::optional<Shaft::Gate> Shaft::gateOf(const Visit& visit) {
  const MetSector sector = meet(visit.sector);
  if (sector.meshesBegin < sector.meshesEnd || scene_[visit.sector].floor.flatPortal ||
      scene_[visit.sector].ceiling.flatPortal)
    return std::nullopt;
  const Met* gate = nullptr;
  for (const Met& met : wallsOf(sector)) {
    if (isHidden(sector, met)) continue;
    if (gate || met.startsInside || met.endsInside || met.stops ||
        met.lastExit != met.firstExit + 1)
      return std::nullopt;
    gate = &met;
  }
  if (!gate || std::ranges::find(screens_, gate->screen) == screens_.end()) return std::nullopt;
  return Gate{gate->wall, exits_[gate->firstExit]};
}

void Shaft::goThroughFlats(const Sector& sector) {
  // A slope may come through the plane of the portal, and stop rays there.
  const auto goTo = [&](const std::vector<SectorId>& members, double z) {
    isStopped_ |= hasSlopeAt(scene_, sector, z);
    for (const SectorId member : members) {
      isStopped_ |= hasSlopeAt(scene_, scene_[member], z);
      go({member, Entry::ThroughFlat, nullptr, {}, {}});
    }
  };
  const auto [zFloor, zCeiling] = scene_.geometryOf(sector);
  if (sector.floor.flatPortal && hull_->zMin() < zFloor)
    goTo(scene_[*sector.floor.flatPortal].lower, zFloor);
  if (sector.ceiling.flatPortal && hull_->zMax() > zCeiling)
    goTo(scene_[*sector.ceiling.flatPortal].upper, zCeiling);
}

/// Whether no target can be in the sector: all are beside it, or beyond a flat portal of it.
bool Shaft::endsOutside(const Sector& sector) const {
  const double margin = hull_->margin();
  const auto all = [&](auto&& isBeyond) {
    return std::ranges::all_of(targets_->box.corners(), isBeyond);
  };
  return all([&](Vec3 p) { return p.x < sector.box.min.x - margin; }) ||
         all([&](Vec3 p) { return p.x > sector.box.max.x + margin; }) ||
         all([&](Vec3 p) { return p.y < sector.box.min.y - margin; }) ||
         all([&](Vec3 p) { return p.y > sector.box.max.y + margin; }) ||
         (sector.floor.flatPortal &&
          all([&](Vec3 p) { return p.z < scene_.zFloor(sector) - margin; })) ||
         (sector.ceiling.flatPortal &&
          all([&](Vec3 p) { return p.z > scene_.zCeiling(sector) + margin; }));
}

/// Whether no flat or slope of the targets' sector stops a ray before its target.
bool Shaft::areTargetsClear() const {
  const TargetRays rays{light_->center, light_->radius, hull_->reach(), hull_->noise(),
                        hull_->margin()};
  return isAirClear(scene_, scene_[targets_->sectors.front()], rays, targets_->box.corners());
}

}  // namespace hearth
