#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"
#include "level/scene.h"

namespace hearth {

/// Builds small levels for tests by hand: sectors of loops whose vertices already agree with their
/// neighbours', so that nothing needs to be welded or split.
class TestLevel {
 public:
  struct Heights {
    double floor = 0;
    double ceiling = 4;
  };

  /// A mapping of a texture of its own, which shows in `textures()` as an image of w x h texels,
  /// each of a colour of its own.
  TextureMapping texture(int width = 16, int height = 16);

  /// Of what hangs in an opening.
  void makeHole(TextureId texture, int x, int y);

  /// A sector without walls. Its flats and walls wear textures of their own.
  SectorId addSector(std::string name, Heights heights);

  /// Walls run from each vertex to the next. The border first, then the holes.
  void addLoop(SectorId sector, const std::vector<Vec2>& vertices);

  /// A sector with a rectangle for a border: walls 0 to 3 are those at yMin, xMax, yMax and xMin.
  SectorId addBox(std::string name, Vec2 min, Vec2 max, Heights heights);

  /// Opens all pairs of walls of the two sectors that have the same end points.
  void link(SectorId a, SectorId b);

  /// Makes one flat portal of the floors of `upper` and the ceilings of `lower`.
  void connect(const std::vector<SectorId>& upper, const std::vector<SectorId>& lower);

  Sector& sector(SectorId id) { return level_[id]; }
  Segment& wall(SectorId sector, std::size_t index);
  SegmentId wallId(SectorId sector, std::size_t index) const;
  LightSource& addLight(SectorId sector, Vec3 position, double intensity = 255, double falloff = 0);

  /// One image, whatever the side from which it is seen.
  Sprite& addSprite(SectorId sector, Vec3 position, Facing facing, Vec2 sizeMetres,
                    TextureMapping image);

  /// Its faces are where they are in the level.
  Mesh& addMesh(SectorId sector, std::string name, const std::vector<MeshFace>& faces);

  /// Derives what is derived. Once only for a level with things. Sectors are in order of their
  /// first loop: add all loops of one sector before the next one's.
  const Level& finished();
  const Level& level() const { return level_; }
  /// Once finished.
  Scene scene() const { return {level_, geometry_}; }
  const std::vector<Image>& textures() const { return textures_; }

 private:
  std::uint32_t thingCount() const {
    return static_cast<std::uint32_t>(level_.sprites.size() + level_.meshes.size());
  }

  Level level_;
  Geometry geometry_;
  std::vector<Image> textures_;
};

/// 90 degrees over 8 pixels: 4 pixels per tangent, the horizon at row 2.
inline Shot cameraAt(SectorId sector, Vec3 eye, double angle = 0) {
  Shot camera;
  camera.sector = sector;
  camera.eye = eye;
  camera.angle = angle;
  camera.width = 8;
  camera.height = 4;
  return camera;
}

}  // namespace hearth
