#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "level/bake_settings.h"
#include "level/face_tree.h"
#include "level/ids.h"
#include "level/light_source.h"
#include "level/mesh.h"
#include "level/mover.h"
#include "level/sector.h"
#include "level/segment.h"
#include "level/sprite.h"
#include "level/surface.h"
#include "level/texel_holes.h"
#include "level/thing_body.h"
#include "level/wall_grid.h"

namespace hearth {

struct Player {
  SectorId sector;
  Vec3 eye;             ///< absolute
  double angle = 0;     ///< degrees; 0 looks along +x, 90 along +y
  double height = 1.8;  ///< of the body, in metres
  double eyeHeight = 1.6;
  double radius = 0.3;
  double stepHeight = 0.4;
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
  std::vector<MoverShare> movers{};  ///< each at most once; the others stand at share 0
};

/// A wall, or one sub-wall of a stack, that starts a mover.
struct MoverSwitch {
  SegmentId segment;
  std::optional<std::uint32_t> subWall;  ///< none: all of the wall
  std::size_t mover;                     ///< index into Level::movers
  bool isCrossed;  ///< by walking through it from its front; else by the use key
};

/// A surface of a wall that shows another texture while a mover that the wall starts is not where
/// it is authored.
struct SwitchTexture {
  SurfaceId surface;
  std::size_t mover;  ///< index into Level::movers
  TextureId off;
  TextureId on;
};

/// A body that reaches into the air of a sector.
struct BodyInSector {
  SectorId sector;
  std::uint32_t body;  ///< index
};

/// A mesh some of whose faces reach into the air of a sector.
struct MeshInSector {
  SectorId sector;
  std::uint32_t mesh;  ///< index
};

/// A level as authored, linked and valid. Immutable once `linkSurfaces` has run. Data that follows
/// from heights lives in a `Geometry`; data of a frame or a bake lives with the renderer and the
/// bakery.
struct Level {
  std::string name;
  std::vector<std::string> textures;  ///< names, by TextureId
  std::vector<TexelHoles>
      holes;  ///< of masked middle textures, by TextureId; may be shorter than `textures`
  std::vector<Sector> sectors;
  std::vector<Segment> segments;
  std::vector<FlatPortal> flatPortals;
  std::vector<Mover> movers;
  std::vector<MoverSwitch> switches;          ///< by segment
  std::vector<SwitchTexture> switchTextures;  ///< by surface: of the same one after another
  std::vector<Sprite> sprites;  ///< of two things at one place the later hides the earlier
  std::vector<Mesh> meshes;
  std::vector<MeshFace> meshFaces;
  std::vector<LightSource> lights;  ///< those with a place first, then the suns, the sky, emitters
  /// By TextureId: how much of red, green and blue light it reflects, 0..1, if nothing reduces it.
  /// May be shorter than `textures`, whose others reflect nothing.
  std::vector<Vec3> reflectances;
  BakeSettings bake;
  std::optional<Player> player;
  std::vector<Shot> shots;

  // Set by `linkSurfaces`:
  std::vector<Surface>
      surfaces;  ///< all that can show, at whatever heights; things last: sprites, then meshes
  std::vector<WallSurfaces> wallSurfaces;     ///< of all segments
  std::vector<SegmentId> entrances;           ///< of all sectors
  std::uint32_t maskedMiddlesInOpenings = 0;  ///< each counts on both sides of its opening
  std::vector<WallGrid> wallGrids;            ///< of sectors with many walls

  std::vector<FaceTree> faceTrees;  ///< by mesh
  std::vector<ThingBody> bodies;    ///< of sprites, then of meshes; set by `addBodies`

  // By sector, then by index:
  std::vector<BodyInSector> bodiesBySector;  ///< set by `addBodies`
  std::vector<MeshInSector> meshesBySector;  ///< set by `addMeshSectors`

  const Sector& operator[](SectorId id) const { return sectors[id.index()]; }
  Sector& operator[](SectorId id) { return sectors[id.index()]; }
  const Segment& operator[](SegmentId id) const { return segments[id.index()]; }
  Segment& operator[](SegmentId id) { return segments[id.index()]; }
  const Surface& operator[](SurfaceId id) const { return surfaces[id.index()]; }
  const FlatPortal& operator[](FlatPortalId id) const { return flatPortals[id.index()]; }

  /// Of the surface of a sprite.
  const Sprite& spriteOf(SurfaceId id) const {
    return sprites[id.index() - sprites.front().surface.index()];
  }

  /// Of the surface of a mesh.
  std::uint32_t meshIndexOf(SurfaceId id) const {
    return static_cast<std::uint32_t>(id.index() - meshes.front().surface.index());
  }
  const Mesh& meshOf(SurfaceId id) const { return meshes[meshIndexOf(id)]; }
  std::span<const MeshFace> facesOf(const Mesh& mesh) const {
    return {meshFaces.data() + mesh.firstFace, mesh.faceCount};
  }
  /// Of one of `meshFaces`.
  std::uint32_t indexOf(const MeshFace& face) const {
    return static_cast<std::uint32_t>(&face - meshFaces.data());
  }

  std::span<const BodyInSector> bodiesIn(SectorId sector) const {
    return inSector(bodiesBySector, sector);
  }
  std::span<const MeshInSector> meshesIn(SectorId sector) const {
    return inSector(meshesBySector, sector);
  }

  std::span<const MoverSwitch> switchesOf(SegmentId segment) const {
    return {std::ranges::lower_bound(switches, segment, {}, &MoverSwitch::segment),
            std::ranges::upper_bound(switches, segment, {}, &MoverSwitch::segment)};
  }
  /// Whether some wall starts a mover.
  bool hasSwitch(std::size_t mover) const {
    return std::ranges::find(switches, mover, &MoverSwitch::mover) != switches.end();
  }

  std::span<const Segment> segmentsOf(const Sector& sector) const {
    return {&segments[sector.firstSegment.index()], sector.segmentCount};
  }
  /// None where looking at all of its walls is as quick.
  const WallGrid* wallGridOf(const Sector& sector) const {
    return sector.wallGrid ? &wallGrids[*sector.wallGrid] : nullptr;
  }
  std::span<const WallSurfaces> surfacesOf(const Segment& segment) const {
    return {wallSurfaces.data() + segment.firstWall, segment.wallCount};
  }
  /// The segments of other sectors that lead into a sector, each once.
  std::span<const SegmentId> entrancesOf(const Sector& sector) const {
    return {entrances.data() + sector.firstEntrance, sector.entranceCount};
  }

 private:
  template <typename T>
  static std::span<const T> inSector(const std::vector<T>& sorted, SectorId sector) {
    const auto first = std::ranges::lower_bound(sorted, sector, {}, &T::sector);
    const auto last = std::ranges::upper_bound(sorted, sector, {}, &T::sector);
    return {first, last};
  }
};

}  // namespace hearth
