#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "level/ids.h"
#include "level/light_source.h"
#include "level/sector.h"
#include "level/segment.h"
#include "level/surface.h"
#include "level/texel_holes.h"

namespace hearth {

struct Player {
  SectorId sector;
  Vec3 eye;             ///< absolute
  double angle = 0;     ///< degrees; 0 looks along +x, 90 along +y
  double height = 1.8;  ///< the body, in metres
  double eyeHeight = 1.6;
  double radius = 0.3;
  double step = 0.4;
};

/// A named camera of the level.
struct Shot {
  std::string name;
  SectorId sector;
  Vec3 eye;
  double angle = 0;  ///< degrees
  double pitch = 0;  ///< degrees, positive upwards
  double fov = 90;   ///< degrees, horizontal
  int width = 320;
  int height = 200;
};

/// All that a level is, linked and valid. Immutable once `finishLevel` has run: what belongs to a
/// frame or to a bake lives with the renderer and the bakery.
struct Level {
  std::string name;
  std::vector<std::string> textures;  ///< names, by TextureId
  std::vector<TexelHoles>
      holes;  ///< of masked middle textures; by TextureId, as far as there are any
  std::vector<Sector> sectors;
  std::vector<Segment> segments;
  std::vector<FlatPortal> flatPortals;
  std::vector<LightSource> lights;
  BakeSettings bake;
  std::optional<Player> player;
  std::vector<Shot> shots;

  // Derived by `finishLevel`:
  std::vector<Surface> surfaces;

  const Sector& operator[](SectorId id) const { return sectors[id.index()]; }
  Sector& operator[](SectorId id) { return sectors[id.index()]; }
  const Segment& operator[](SegmentId id) const { return segments[id.index()]; }
  Segment& operator[](SegmentId id) { return segments[id.index()]; }
  const Surface& operator[](SurfaceId id) const { return surfaces[id.index()]; }
  const FlatPortal& operator[](FlatPortalId id) const { return flatPortals[id.index()]; }

  std::span<const Segment> segmentsOf(const Sector& sector) const {
    return {&segments[sector.firstSegment.index()], sector.segmentCount};
  }
};

}  // namespace hearth
