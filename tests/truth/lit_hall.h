#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh_shapes.h"
#include "test_level.h"
#include "truth/truth_light.h"

namespace hearth {

inline SurfacePoint floorPoint(SectorId sector, Vec2 p) {
  return {SurfaceKind::Floor, sector, std::nullopt, {p.x, p.y, 0}, {0, 0, 1}};
}

/// A point of a face of a finished level: face `face` of mesh `mesh`, seen from its front.
inline SurfacePoint facePoint(const Level& level, std::size_t mesh, std::uint32_t face,
                              Vec3 point) {
  const std::uint32_t index = level.meshes[mesh].firstFace + face;
  const Vec3 front = frontOf(level.meshFaces[index]);
  SurfacePoint place{SurfaceKind::Mesh, level.meshes[mesh].sector, std::nullopt, point,
                     (1 / length(front)) * front};
  place.mesh = level.meshes[mesh].surface;
  place.face = index;
  return place;
}

/// A rectangle at one height, seen from above.
inline std::vector<MeshFace> tableAt(double z, Vec2 min, Vec2 max, TextureId texture) {
  return polygonOf({{min.x, min.y, z}, {min.x, max.y, z}, {max.x, max.y, z}, {max.x, min.y, z}},
                   texture);
}

/// Of the faces of `boxOf`, the first of its top and of its bottom.
inline constexpr std::uint32_t kBoxTop = 10;
inline constexpr std::uint32_t kBoxBottom = 8;

/// A hall of 8 x 8 x 4 m.
struct LitHall {
  TestLevel test;
  SectorId hall = test.addBox("hall", {0, 0}, {8, 8}, {0, 4});
  TextureId image = test.texture().texture;

  Mesh& add(const std::vector<MeshFace>& faces) { return test.addMesh(hall, "mesh", faces); }
  /// A cube of 1 m on the floor.
  Mesh& addCube(Vec2 corner) {
    return add(boxOf({corner.x, corner.y, 0}, {corner.x + 1, corner.y + 1, 1}, image));
  }
  LightSource& light(Vec3 position, double intensity = 100, double falloff = 0) {
    return test.addLight(hall, position, intensity, falloff);
  }
};

/// What white lights add up to.
inline double levelAt(const Level& level, const SurfacePoint& place) {
  return TruthLight(level).at(place).x;
}

}  // namespace hearth
