#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "level/geometry.h"
#include "level/level.h"

namespace hearth {

/// A level seen at its current heights: `Geometry` says where its flats stand now, which may differ
/// from where they were authored. This is what is lit, drawn and walked. It is a view of level and
/// geometry, which must outlive it. Pass and keep it by value, like a pointer.
class Scene {
 public:
  Scene(const Level& level, const Geometry& geometry)
      : level_(&level), geometry_(&geometry), lights_(&level.lights) {}

  const Level& level() const { return *level_; }
  const Geometry& geometry() const { return *geometry_; }
  /// What it is lit by: the lights of the level, unless it has others.
  const std::vector<LightSource>& lights() const { return *lights_; }
  /// The same, lit by others, which must outlive it.
  Scene litBy(const std::vector<LightSource>& lights) const {
    Scene scene = *this;
    scene.lights_ = &lights;
    return scene;
  }

  const Sector& operator[](SectorId id) const { return (*level_)[id]; }
  const Segment& operator[](SegmentId id) const { return (*level_)[id]; }
  const Surface& operator[](SurfaceId id) const { return (*level_)[id]; }
  const FlatPortal& operator[](FlatPortalId id) const { return (*level_)[id]; }

  std::span<const Segment> segmentsOf(const Sector& sector) const {
    return level_->segmentsOf(sector);
  }

  const SectorGeometry& geometryOf(const Sector& sector) const {
    return geometry_->sectors[sector.id.index()];
  }
  const SegmentGeometry& geometryOf(const Segment& segment) const {
    return geometry_->segments[segment.id.index()];
  }
  const SurfaceGeometry& geometryOf(SurfaceId id) const { return geometry_->surfaces[id.index()]; }

  double zFloor(const Sector& sector) const { return geometryOf(sector).zFloor; }
  double zCeiling(const Sector& sector) const { return geometryOf(sector).zCeiling; }

  /// The surfaces that show, in the order of their ids. A surface's number in saved bakes, in
  /// `hearth info` and in channels is its index here, not its SurfaceId: ids also count surfaces
  /// that show only once flats move. Each call looks at all surfaces and allocates.
  std::vector<SurfaceId> shownSurfaces() const {
    std::vector<SurfaceId> shown;
    for (std::size_t i = 0; i < geometry_->surfaces.size(); ++i)
      if (geometry_->surfaces[i].shows) shown.emplace_back(i);
    return shown;
  }

  /// Heights of the sector's air at a point of the map, slopes included.
  double airBottom(const Sector& sector, Vec2 p) const {
    return sector.floorSlope ? sector.floorSlope->zAt(p) : zFloor(sector);
  }
  double airTop(const Sector& sector, Vec2 p) const {
    return sector.ceilingSlope ? sector.ceilingSlope->zAt(p) : zCeiling(sector);
  }

  /// The air of a segment's sector, `fraction` (0..1) of the way from p0 to p1.
  AirColumn airAt(const Segment& segment, double fraction) const {
    const SegmentGeometry& at = geometryOf(segment);
    if (!at.airRises) return at.air0;
    return {std::lerp(at.air0.zBottom, at.air1.zBottom, fraction),
            std::lerp(at.air0.zTop, at.air1.zTop, fraction)};
  }

  /// The pieces of a segment, bottom to top. They cover the segment's air without a gap.
  std::span<const WallPiece> piecesOf(const Segment& segment) const {
    return {geometry_->pieces.data() + Geometry::kPiecesPerWall * segment.firstWall,
            geometryOf(segment).pieceCount};
  }
  std::span<const LightOpening> lightOpeningsOf(const Segment& segment) const {
    return {geometry_->lightOpenings.data() + segment.firstWall,
            geometryOf(segment).lightOpeningCount};
  }
  /// The masked middle textures that hang in an opening, those of both its sides.
  std::span<const SurfaceId> maskedMiddlesIn(const LightOpening& opening) const {
    return {geometry_->maskedMiddles.data() + opening.firstMaskedMiddle, opening.maskedMiddleCount};
  }

 private:
  const Level* level_;
  const Geometry* geometry_;
  const std::vector<LightSource>* lights_;
};

}  // namespace hearth
