#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "level/scene.h"
#include "math/tolerance.h"
#include "math/vec.h"

namespace hearth {

/// A ray on the map.
struct PlanRay {
  Vec2 origin;
  Vec2 delta;
  double tSector;  ///< where it came into the sector
  double length2;  ///< square of the length in space of t = 1
  double tTarget;  ///< its end

  double tBegin() const { return tSector - 2 * kNearTie * std::max(tSector, 1.0); }
  /// Beyond its end it does not matter what it meets.
  double tEnd() const { return tTarget + 2 * kArrival / std::sqrt(length2); }
};

/// All walls and meshes of a sector.
struct AllWalls {
  Scene scene;

  /// Calls `visit(wall)` for all that the ray meets before `nearest()`, and for others.
  template <typename Visit, typename Nearest>
  void visit(SectorId sector, const PlanRay& ray, Visit&& visit, Nearest&& nearest) const {
    const std::span<const Segment> walls = scene.segmentsOf(scene[sector]);
    const WallGrid* const grid = scene.level().wallGridOf(scene[sector]);
    if (!grid) {
      for (const Segment& wall : walls) visit(wall);
      return;
    }
    const double tEnd = ray.tEnd();
    grid->alongRay(ray.origin, ray.delta, ray.tBegin(), [&](CellId cell) {
      for (const std::uint32_t i : grid->wallsIn(cell)) visit(walls[i]);
      return std::min(nearest(), tEnd);
    });
  }
  std::span<const MeshInSector> meshesIn(SectorId sector) const {
    return scene.level().meshesIn(sector);
  }
};

/// Those that the rays of a shaft, to a light or to the sky, can meet.
template <typename AnyShaft>
struct ShaftWalls {
  const AnyShaft& shaft;

  template <typename Visit, typename Nearest>
  void visit(SectorId sector, const PlanRay&, Visit&& visit, Nearest&&) const {
    for (const Segment* wall : shaft.wallsIn(sector)) visit(*wall);
  }
  std::span<const MeshInSector> meshesIn(SectorId sector) const { return shaft.meshesIn(sector); }
};

}  // namespace hearth
