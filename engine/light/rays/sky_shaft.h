#pragma once

#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/rays/id_set.h"
#include "light/rays/shaft_hull.h"
#include "light/rays/shaft_targets.h"

namespace hearth {

/// Follows all rays from a box of targets towards a sun at once, through the openings that their
/// hull meets, to the skies where they end. Its answer is the ray tracer's for each of the rays; if
/// they differ, or may differ, it gives none. It records which walls the hull meets: the rays meet
/// no others.
class SkyShaft {
 public:
  explicit SkyShaft(const Scene& scene) : scene_(scene) {}

  /// `within`, if any, is a shaft to the same sun from a box that contains this one.
  TargetVisibility follow(const SunCone& sun, const ShaftTargets& targets, const SkyShaft* within);

  /// Adds the sectors that rays can enter.
  void addSectorsTo(SectorSet& sectors) const {
    for (const MetSector& sector : sectors_) sectors.add(sector.id);
  }

  /// The walls that rays can meet in a sector that they can enter.
  std::span<const Segment* const> wallsIn(SectorId sector) const;
  /// Likewise the meshes.
  std::span<const MeshInSector> meshesIn(SectorId sector) const;

 private:
  struct MetSector {
    SectorId id;
    std::uint32_t begin;  ///< in `walls_`
    std::uint32_t end;
    std::uint32_t meshesBegin;  ///< those that the hull may meet, and that stop light
    std::uint32_t meshesEnd;
  };

  const MetSector* find(SectorId sector) const;
  void enter(SectorId sector);
  void visit(std::size_t index);
  void meetWalls(const Sector& sector);
  void meetWall(const Sector& sector, const Segment& wall);
  bool isHarmless(const Segment& wall) const;
  void meetFlats(const Sector& sector);
  void goThroughFlat(const Sector& sector, const std::vector<SectorId>& members, double z);
  void meetMeshes(SectorId sector);

  Scene scene_;
  const SkyShaft* within_ = nullptr;
  const SunCone* sun_ = nullptr;
  std::optional<ShaftHull> hull_;

  std::vector<const Segment*> walls_;
  std::vector<MeshInSector> meshes_;
  std::vector<MetSector> sectors_;
  std::pmr::vector<std::uint32_t> near_;  ///< walls of a wall grid that the hull may meet
  bool arrives_ = false;                  ///< some ray, perhaps, in a sky
  bool isStopped_ = false;                ///< some ray, perhaps, by what is no mesh
};

}  // namespace hearth
