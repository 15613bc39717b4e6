#pragma once

#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "level/mesh.h"
#include "level/scene.h"
#include "light/rays/id_set.h"
#include "light/rays/shaft_hull.h"
#include "light/rays/shaft_targets.h"

namespace hearth {

/// Where the rays of a light start.
struct ShaftLight {
  Vec3 center;
  double radius = 0;              ///< metres
  std::vector<SectorId> sectors;  ///< in which rays start
  /// Whether no ray starts in the parts of the ball behind walls of its sector.
  bool isCutByWalls = false;
};

/// Follows all rays from a light to a box of targets at once, through the openings that their hull
/// meets. Its answer is the ray tracer's for each of the rays; if they differ, or may differ, it
/// gives none. It records which walls the hull meets: the rays meet no others.
///
/// In a sector, walls side by side that the hull meets can be a screen, which crosses all of the
/// hull between light and targets. Rays that enter the sector before the screen leave the sector
/// through it, or end at it.
class Shaft {
 public:
  explicit Shaft(const Scene& scene) : scene_(scene) {}

  /// `within`, if any, is a shaft of the same light to a box that contains this one.
  TargetVisibility follow(const ShaftLight& light, const ShaftTargets& targets,
                          const Shaft* within);

  /// Adds the sectors that rays can enter.
  void addSectorsTo(SectorSet& sectors) const {
    for (const MetSector& sector : sectors_) sectors.add(sector.id);
  }

  /// Whether rays can enter a sector, and the walls that they can meet there.
  bool meets(SectorId sector) const;
  std::span<const Segment* const> wallsIn(SectorId sector) const;
  /// Likewise the meshes.
  std::span<const MeshInSector> meshesIn(SectorId sector) const;

  /// An opening of a wall through which all rays pass. All openings that they pass before it are
  /// gates, too.
  struct Gate {
    const Segment* wall;
    const LightOpening* opening;
  };
  /// The last gate.
  const std::optional<Gate>& gate() const { return gate_; }

  /// A face that rays may meet.
  struct Face {
    const MeshFace* face;
    /// Whether its mesh is in all sectors on the way. In others it stops no rays, though it may be
    /// there.
    bool stopsAll;
  };
  /// All such faces, if these are known, and few.
  std::optional<std::span<const Face>> faces() const {
    return areFacesKnown_ ? std::optional(std::span<const Face>(faces_)) : std::nullopt;
  }
  /// Whether all rays arrive that no face stops.
  bool isOpenButForFaces() const { return isOpenButForFaces_; }

 private:
  /// A wall that the hull meets.
  struct Met {
    const Segment* wall;
    Vec2 normal;  ///< unit, to its front
    Vec2 start;   ///< of the part that the hull meets
    Vec2 end;
    bool startsInside;  ///< the wall's p0 lies in the hull
    bool endsInside;
    double minOfLight;    ///< metres in front of the wall
    double maxOfTargets;  ///< likewise
    bool stops;           ///< some rays, perhaps
    std::uint32_t firstExit;
    std::uint32_t lastExit;
    std::uint32_t screen;  ///< 0: none

    double inFront(Vec2 p) const { return dot(normal, p - wall->p0); }
  };
  struct MetSector {
    SectorId id;
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t screens;
    std::uint32_t meshesBegin;  ///< those that the hull may meet, and that stop light
    std::uint32_t meshesEnd;
  };
  enum class Entry { FromLight, ThroughWall, ThroughFlat };
  /// An entry into a sector.
  struct Visit {
    SectorId sector;
    Entry entry;
    const LightOpening* through;  ///< for ThroughWall
    Vec2 start;
    Vec2 end;
  };

  const MetSector& meet(SectorId id);
  void meetWall(const Sector& sector, SectorId id, const Segment& wall);
  bool isHarmless(SectorId id, const Segment& wall, const ShaftHull::Distances& distances) const;
  void meetOpenings(const Sector& sector, const ShaftHull::Slice& slice, Met& met);
  void meetMeshes(MetSector& sector);
  bool findFaces();
  bool addFacesOf(std::uint32_t mesh, bool stopsAll);
  void findScreens(MetSector& sector);
  void findScreenFrom(MetSector& sector, Met& first);
  Met* nextInLoop(const MetSector& sector, const Met& met);
  std::span<Met> wallsOf(const MetSector& sector) {
    return std::span(mets_).subspan(sector.begin, sector.end - sector.begin);
  }

  void visit(const Visit& visit);
  bool isScreen(const MetSector& sector, std::uint32_t screen, const Visit& visit);
  bool isHidden(const MetSector& sector, const Met& met);
  bool isBehind(const MetSector& sector, std::uint32_t screen, const Met& met);
  std::optional<Gate> gateOf(const Visit& visit);
  void go(const Visit& visit);
  void goThroughGate();
  void goThroughFlats(const Sector& sector);
  bool endsOutside(const Sector& sector) const;
  bool isTarget(SectorId id) const;
  bool areTargetsClear() const;

  Scene scene_;
  const Shaft* within_ = nullptr;
  const ShaftLight* light_ = nullptr;
  const ShaftTargets* targets_ = nullptr;
  std::optional<ShaftHull> hull_;
  double minInFront_ = 0;

  std::vector<Met> mets_;
  std::vector<const Segment*> walls_;  ///< of `mets_`
  std::vector<MeshInSector> meshes_;
  std::vector<const LightOpening*> exits_;
  std::vector<MetSector> sectors_;
  std::vector<Visit> visits_;
  std::pmr::vector<std::uint32_t> near_;  ///< walls of a wall grid that the hull may meet
  std::vector<std::uint32_t> chain_;      ///< of `mets_`: a screen that may be
  std::vector<std::uint32_t> screens_;    ///< before the way of the visit at hand
  std::optional<Gate> gate_;
  std::vector<Face> faces_;
  bool areFacesKnown_ = false;
  bool isOpenButForFaces_ = false;
  bool arrives_ = false;    ///< some ray, perhaps, at its target
  bool isStopped_ = false;  ///< some ray, perhaps, elsewhere, by what is no mesh
};

}  // namespace hearth
