#pragma once

#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "level/level.h"
#include "light/light_kernels.h"

namespace hearth {

/// What a cone is bounded by above or below: the plane through the light and a straight edge of an
/// opening.
struct HeightPlane {
  Vec2 gradient;         ///< metres of height for each metre from the light, along x and y
  bool isBelow;          ///< whether the cone lies above it
  double slackPerMetre;  ///< by which rounding may move it, metres for each metre from the light
};

/// What a light sees of a sector through a row of openings, up to one wall of it. All of its bounds
/// are planes, most of them through the light; lines on the map are given as directions of length 1
/// from there.
struct LightCone {
  SectorId sector;
  const Segment* from;  ///< beyond this wall; null where none is before it
  const Segment* to;    ///< up to this one
  Vec2 begin;           ///< it lies clockwise of this, as seen on the map,
  Vec2 end;             ///< and not of this; less than 180 degrees
  Vec2 beginsAt;        ///< from the light to the vertices that say so
  Vec2 endsAt;
  std::uint32_t firstPlane;
  std::uint32_t lastPlane;
  /// Whether it may be dark in there: behind textures with holes, and where a cone is so narrow
  /// that rounding decides what it meets (`begin` is `end` then).
  bool isDoubtful;
};

/// All cones of a light.
struct LightConeSet {
  std::vector<LightCone> cones;
  std::vector<HeightPlane> planes;
  /// Sectors that light may come to in ways that no cone describes.
  std::unordered_set<std::uint32_t> unknown;
  /// Whether there are not too many of them to be found.
  bool isComplete = false;

  std::span<const HeightPlane> planesOf(const LightCone& cone) const {
    return std::span(planes).subspan(cone.firstPlane, cone.lastPlane - cone.firstPlane);
  }
  /// With what LightCones keeps of each: half a dozen bounds, and its sides.
  std::size_t bytes() const {
    return cones.size() * (sizeof(LightCone) + 6 * sizeof(ConeBound) + 4 * sizeof(double)) +
           planes.size() * sizeof(HeightPlane);
  }
};

}  // namespace hearth
