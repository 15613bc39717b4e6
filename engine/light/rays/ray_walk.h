#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "level/face_ray.h"
#include "level/locate.h"
#include "level/masked_middle.h"
#include "level/openings.h"
#include "light/ray_error.h"
#include "light/rays/plan_line.h"
#include "light/rays/ray_walls.h"
#include "light/rays/raytracer.h"
#include "math/box3.h"
#include "math/tolerance.h"

namespace hearth {

/// Metres before the end of a ray that no mesh stops.
inline constexpr double kThroughMeshes = std::numeric_limits<double>::infinity();

inline bool areApart(const Box3& a, const Box3& b) {
  return a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y ||
         a.max.z < b.min.z || b.max.z < a.min.z;
}

/// A ray on its way through the sectors. `Walls`: AllWalls, or ShaftWalls.
template <typename Walls>
class RayWalk {
 public:
  /// From the source by `delta`, or so many times as far. `met`, if any, gets the sectors that the
  /// ray enters.
  RayWalk(const Scene& scene, Walls walls, const Raytracer::Source& source, Vec3 delta,
          bool solidMaskedMiddles, SectorSet* met, double times = 1)
      : scene_(scene),
        walls_(walls),
        solidMaskedMiddles_(solidMaskedMiddles),
        met_(met),
        origin_(source.position),
        delta_(delta),
        length2_(dot(delta_, delta_)),
        line_(origin_.xy(), delta_.xy(), length2_, times),
        sector_(source.sector) {}

  /// To where the ray, going on, comes to in the end.
  void passGate(const Shaft::Gate& gate) {
    const Segment& wall = *gate.wall;
    sector_ = gate.opening->next;
    t_ = line_.crossingOf(wall);
    entry_ = &scene_[gate.opening->twin];
  }

  /// Whether the ray's end is a point on the border of the air of `goal` that it reaches. Meshes
  /// stop it, except within `slack` metres of its end.
  bool arrivesAt(SectorId goal, double slack) {
    for (std::size_t step = 0; step < stepLimit(); ++step) {
      const Exit exit = findExit();
      const std::optional<FlatHit> hit = meetsFlat(std::min(exit.t, 1.0));
      if (meetsMesh(hit ? hit->t : exit.t, slack)) return false;
      if (hit) {
        if (sector_ == goal && isAtEnd(hit->t)) return true;
        if (!crossFlatPortal(*hit)) return false;
        continue;
      }
      if (sector_ == goal && isAtEnd(exit.t)) return true;
      if (exit.t > 1 && !isNearEnd(exit.t)) return liesBehindFlatPortal(goal);
      if (!pass(exit, isAtEnd(exit.t) ? kArrival : 0)) return false;
    }
    return false;
  }

  /// Whether the ray, whose end lies beyond the level, first meets a sky. No mesh stops it within
  /// `slack` metres of its start.
  bool endsInSky(double slack) {
    skiesStop_ = true;
    meshesFrom_ = slack / std::sqrt(length2_);
    for (std::size_t step = 0; step < stepLimit(); ++step) {
      const Exit exit = findExit();
      const std::optional<FlatHit> hit = meetsFlat(std::min(exit.t, line_.tEnd()));
      if (meetsMesh(hit ? hit->t : exit.t, 0)) return false;
      if (hit) {
        if (flatOf(*hit).isSky) return true;
        if (!crossFlatPortal(*hit)) return false;
        continue;
      }
      if (exit.t > line_.tEnd() || !pass(exit, 0)) return false;
      if (isBeyondSky()) return true;
    }
    return false;
  }

  /// The sector of the ray's end, a point of the air; none where it does not get there. Walls and
  /// flats stop it except within `slack` metres of its end, meshes except within `meshSlack`. (A
  /// point of the air lies on no surface that would stop the ray; a mesh may touch one.)
  std::optional<SectorId> sectorAtEnd(double slack, double meshSlack) {
    const auto endsWithin = [&](double t) {
      return slack > 0 && t >= 1 - slack / std::sqrt(length2_);
    };
    for (std::size_t step = 0; step < stepLimit(); ++step) {
      const Exit exit = findExit();
      const std::optional<FlatHit> hit = meetsFlat(std::min(exit.t, 1.0));
      if (meetsMesh(hit ? hit->t : exit.t, meshSlack)) return std::nullopt;
      if (hit) {
        if (crossFlatPortal(*hit)) continue;
        return endsWithin(hit->t) ? std::optional(sector_) : std::nullopt;
      }
      if (exit.t > 1) return sector_;
      if (pass(exit, 0)) continue;
      return endsWithin(exit.t) ? std::optional(sector_) : std::nullopt;
    }
    return std::nullopt;
  }

  /// Whether it passes all faces that it may meet, except within `slack` metres of its end; none if
  /// the sectors on its way must tell.
  std::optional<bool> passesFacesOf(const Shaft& shaft, double slack) const {
    const auto faces = shaft.faces();
    if (!faces) return std::nullopt;
    if (faces->empty()) return true;
    const FaceRay ray(origin_, delta_);
    const double metres = std::sqrt(length2_);
    const double tFrom = std::max(0.0, t_ - kPositionSlack / metres);
    const double tTo = 1 - slack / metres;
    std::optional<bool> passes = true;
    for (const auto& [face, stopsAll] : *faces) {
      if (!ray.meets(*face, tFrom, tTo)) continue;
      if (stopsAll) return false;
      passes.reset();
    }
    return passes;
  }

  /// Whether the ray first meets the back of a face, of meshes that are in the sector where it
  /// starts.
  bool meetsBackFirst() {
    const std::span<const MeshInSector> meshes = scene_.level().meshesIn(sector_);
    faceRay_.emplace(origin_, delta_);
    for (std::size_t step = 0; step < stepLimit(); ++step) {
      const Exit exit = findExit();
      const std::optional<FlatHit> hit = meetsFlat(std::min(exit.t, 1.0));
      const double tLeave = std::min(hit ? hit->t : exit.t, 1.0);
      if (const auto crossing = nearestFace(meshes, tLeave)) return !crossing->isFront;
      if (hit ? !crossFlatPortal(*hit) : exit.t > 1 || !pass(exit, 0)) return false;
    }
    return false;
  }

 private:
  /// No line through a level that means something crosses so many sectors.
  std::size_t stepLimit() const { return 4 * scene_.level().segments.size() + 16; }

  /// Within kArrival of the ray's end. (Asked of each ray, so without root and division.)
  bool isNearEnd(double t) const { return (1 - t) * (1 - t) * length2_ <= kArrival * kArrival; }
  bool isAtEnd(double t) const { return t >= 1 || isNearEnd(t); }

  Exit findExit() const {
    if (met_) met_->add(sector_);
    return line_.exitOf(walls_, sector_, t_, entry_);
  }

  double zAt(double t) const { return origin_.z + t * delta_.z; }
  Vec2 planAt(double t) const { return line_.at(t); }

  struct FlatHit {
    double t;
    bool isFloor;
  };

  const Flat& flatOf(const FlatHit& hit) const {
    return hit.isFloor ? scene_[sector_].floor : scene_[sector_].ceiling;
  }

  /// Where, up to tEnd, the ray first meets the sector's floor or ceiling (slopes included, which
  /// may come through one another; skies are none to light, unless it is sought there).
  std::optional<FlatHit> meetsFlat(double tEnd) const {
    const Sector& sector = scene_[sector_];
    const auto stops = [this](const Flat& flat) { return skiesStop_ || !flat.isSky; };
    std::optional<FlatHit> first;
    if (stops(sector.floor) && (delta_.z < 0 || sector.floorSlope))
      if (const auto t = meetsPlane(tEnd, 1, [&](Vec2 p) { return scene_.airBottom(sector, p); }))
        first = FlatHit{*t, true};
    if (stops(sector.ceiling) && (delta_.z > 0 || sector.ceilingSlope))
      if (const auto t = meetsPlane(tEnd, -1, [&](Vec2 p) { return scene_.airTop(sector, p); }))
        if (!first || *t < first->t) first = FlatHit{*t, false};
    return first;
  }

  /// Whether the ray came into its sector through the step between two skies.
  bool isBeyondSky() const {
    const Sector& sector = scene_[sector_];
    const Vec2 p = planAt(t_);
    return (sector.floor.isSky && zAt(t_) < scene_.airBottom(sector, p)) ||
           (sector.ceiling.isSky && zAt(t_) > scene_.airTop(sector, p));
  }

  template <typename HeightAt>
  std::optional<double> meetsPlane(double tEnd, double sign, HeightAt&& heightAt) const {
    const auto clearance = [&](double t) { return sign * (zAt(t) - heightAt(planAt(t))); };
    const double atEnd = clearance(tEnd);
    if (atEnd >= 0) return std::nullopt;
    const double atStart = std::max(0.0, clearance(t_));
    return t_ + (tEnd - t_) * (atStart / (atStart - atEnd));
  }

  /// Whether a mesh stops the ray in its sector, which it leaves, or in which it meets a flat, at
  /// `tLeave`. A face in the very plane of an opening or a flat portal stops it on either side.
  bool meetsMesh(double tLeave, double slack) {
    if (scene_.level().meshes.empty() || slack == kThroughMeshes) return false;
    const std::span<const MeshInSector> meshes = walls_.meshesIn(sector_);
    if (meshes.empty()) return false;
    if (!faceRay_) faceRay_.emplace(origin_, delta_);
    const double metres = std::sqrt(length2_);
    const double hair = kPositionSlack / metres;
    const double tBegin = std::max(meshesFrom_, t_ - hair);
    const double tEnd = std::min(tLeave + hair, line_.tEnd() - slack / metres);
    return std::ranges::any_of(meshes, [&](const MeshInSector& at) {
      return scene_.level().meshes[at.mesh].castsShadow && meetsFace(at.mesh, tBegin, tEnd);
    });
  }

  bool meetsFace(std::uint32_t mesh, double tBegin, double tEnd) const {
    const Level& level = scene_.level();
    return level.faceTrees[mesh].stops(level.facesOf(level.meshes[mesh]), *faceRay_, tBegin, tEnd);
  }

  bool isHere(std::uint32_t mesh) const {
    const std::span<const MeshInSector> here = scene_.level().meshesIn(sector_);
    const auto found = std::ranges::lower_bound(here, mesh, {}, &MeshInSector::mesh);
    return found != here.end() && found->mesh == mesh;
  }

  /// Of meshes that have an inside, from the origin on in the sector where the ray is. Up to
  /// kArrival apart things touch: what the origin touches is its surface, a face that touches what
  /// ends the air is in it, and a back comes before a front that it touches.
  std::optional<FaceRay::Crossing> nearestFace(std::span<const MeshInSector> meshes,
                                               double tLeave) const {
    const double tie = kArrival / std::sqrt(length2_);
    const double tFrom = std::max(t_ - tie, tie);
    const Box3 box = boxAround(tFrom, tLeave + tie);
    std::optional<FaceRay::Crossing> nearest;
    for (const MeshInSector& at : meshes) {
      const Mesh& mesh = scene_.level().meshes[at.mesh];
      // Of many meshes in a sector most are elsewhere.
      if (areApart(box, scene_.level().faceTrees[at.mesh].box())) continue;
      if (!mesh.castsShadow || mesh.isTwoSided || !isHere(at.mesh)) continue;
      const auto crossing = scene_.level().faceTrees[at.mesh].nearest(
          scene_.level().facesOf(mesh), *faceRay_, tFrom, tLeave + tie, tie);
      if (crossing && (!nearest || crossing->place(tie) < nearest->place(tie))) nearest = crossing;
    }
    return nearest;
  }

  /// Around the ray between two parameters, and what it may touch there.
  Box3 boxAround(double tFrom, double tTo) const {
    Box3 box;
    box.add(origin_ + tFrom * delta_);
    box.add(origin_ + tTo * delta_);
    const double slack =
        kArrival + roundingOf(largestCoordinate(box.min) + largestCoordinate(box.max));
    const Vec3 margin{slack, slack, slack};
    return {box.min - margin, box.max + margin};
  }

  const std::vector<SectorId>& membersBehind(const Flat& flat, bool isFloor) const {
    const FlatPortal& flatPortal = scene_[*flat.flatPortal];
    return isFloor ? flatPortal.lower : flatPortal.upper;
  }

  /// A surface can lie in the very plane of a flat portal: a slope that touches it.
  bool liesBehindFlatPortal(SectorId goal) const {
    const Sector& sector = scene_[sector_];
    const auto leadsToGoal = [&](const Flat& flat, double z, bool isFloor) {
      return flat.flatPortal && std::abs(zAt(1) - z) <= kArrival &&
             std::ranges::find(membersBehind(flat, isFloor), goal) !=
                 membersBehind(flat, isFloor).end() &&
             contains(scene_.level(), scene_[goal], planAt(1));
    };
    return leadsToGoal(sector.floor, scene_.zFloor(sector), true) ||
           leadsToGoal(sector.ceiling, scene_.zCeiling(sector), false);
  }

  bool crossFlatPortal(FlatHit hit) {
    const Flat& flat = flatOf(hit);
    if (!flat.flatPortal) return false;
    sector_ = memberAt(flat, hit);
    t_ = hit.t;
    entry_ = nullptr;
    return true;
  }

  /// The sector behind a flat portal that the ray is in. Along a border of two of them it is the
  /// one whose outline the ray's crossings say, so that it leaves what it was in.
  SectorId memberAt(const Flat& flat, FlatHit hit) const {
    for (const SectorId member : membersBehind(flat, hit.isFloor))
      if (line_.isInside(scene_.segmentsOf(scene_[member]), hit.t)) return member;
    return sectorAcross(scene_.level(), scene_[*flat.flatPortal],
                        hit.isFloor ? FlatPortalSide::Lower : FlatPortalSide::Upper, planAt(hit.t));
  }

  /// Goes through the opening of the exit at the ray's height, or within `slack` metres of that, if
  /// there is one.
  bool pass(const Exit& exit, double slack) {
    for (const LightOpening& opening : scene_.lightOpeningsOf(*exit.segment)) {
      if (!isOpenAt(opening, exit.t, slack)) continue;
      if (slack == 0 && isStoppedByMaskedMiddle(opening, exit.t)) return false;
      sector_ = opening.next;
      t_ = exit.t;
      entry_ = &scene_[opening.twin];
      return true;
    }
    return false;
  }

  /// Whether the opening, and the slopes of the sector behind it, leave the ray's height free.
  bool isOpenAt(const LightOpening& opening, double t, double slack) const {
    const double z = zAt(t);
    if (z < opening.zBottom - slack || z > opening.zTop + slack) return false;
    const Sector& next = scene_[opening.next];
    if (!next.floorSlope && !next.ceilingSlope) return true;
    const Segment& twin = scene_[opening.twin];
    const double fraction = length(planAt(t) - twin.p0) / twin.length;
    const AirColumn air = scene_.airAt(twin, std::clamp(fraction, 0.0, 1.0));
    return (!next.floorSlope || z >= air.zBottom - slack) &&
           (!next.ceilingSlope || z <= air.zTop + slack);
  }

  /// Whether the ray meets what hangs in an opening, on either side, and is no hole.
  bool isStoppedByMaskedMiddle(const LightOpening& opening, double t) const {
    return std::ranges::any_of(scene_.maskedMiddlesIn(opening), [&](SurfaceId id) {
      const SurfaceGeometry& middle = scene_.geometryOf(id);
      const Vec2 p = planAt(t);
      const double z = zAt(t);
      return middle.zBottom <= z && z <= middle.zTop &&
             (solidMaskedMiddles_ || isSolidAt(scene_, id, {p.x, p.y, z}));
    });
  }

  Scene scene_;
  Walls walls_;
  bool solidMaskedMiddles_;
  SectorSet* met_;
  Vec3 origin_;
  Vec3 delta_;
  double length2_;
  PlanLine line_;  ///< to where it ends: 1, or far away for a ray to the sky

  std::optional<FaceRay> faceRay_;  ///< the ray, once meshes are asked
  double meshesFrom_ = 0;           ///< fraction of its way before which no mesh stops the ray
  bool skiesStop_ = false;

  SectorId sector_;                 ///< where the ray is ...
  double t_ = 0;                    ///< ... since this fraction of its way ...
  const Segment* entry_ = nullptr;  ///< ... through this segment of the sector, if through one
};

}  // namespace hearth
