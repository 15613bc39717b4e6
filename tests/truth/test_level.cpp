#include "test_level.h"

#include <utility>

#include "level/link_surfaces.h"
#include "level/mesh_sectors.h"
#include "math/check.h"

namespace hearth {

TextureMapping TestLevel::texture(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                        static_cast<std::uint8_t>(textures_.size())};
  textures_.push_back(image);
  level_.textures.push_back("texture" + std::to_string(textures_.size()));
  TextureMapping mapping;
  mapping.texture = TextureId(textures_.size() - 1);
  return mapping;
}

void TestLevel::makeHole(TextureId texture, int x, int y) {
  Image& image = textures_[texture.index()];
  image.makeHole(x, y);
  level_.holes.resize(textures_.size());
  TexelHoles& holes = level_.holes[texture.index()];
  if (holes.bits().empty()) holes = TexelHoles(image.width(), image.height());
  holes.setHole(x, y);
}

SectorId TestLevel::addSector(std::string name, Heights heights) {
  Sector sector;
  sector.name = std::move(name);
  sector.floor.z = heights.floor;
  sector.floor.texture = texture();
  sector.ceiling.z = heights.ceiling;
  sector.ceiling.texture = texture();
  sector.firstSegment = SegmentId(level_.segments.size());
  level_.sectors.push_back(std::move(sector));
  return SectorId(level_.sectors.size() - 1);
}

void TestLevel::addLoop(SectorId id, const std::vector<Vec2>& vertices) {
  Sector& sector = level_[id];
  CHECK(sector.firstSegment.index() + sector.segmentCount == level_.segments.size(), sector.name);
  const auto loop = static_cast<std::uint32_t>(sector.loops.size());
  const auto count = static_cast<std::uint32_t>(vertices.size());
  sector.loops.push_back({"", SegmentId(level_.segments.size()), count});
  for (std::uint32_t i = 0; i < count; ++i) {
    Segment segment;
    segment.p0 = vertices[i];
    segment.p1 = vertices[(i + 1) % count];
    segment.sector = id;
    segment.loop = loop;
    segment.wallIndex = i;
    segment.wall = Solid{texture()};
    level_.segments.push_back(segment);
  }
  sector.segmentCount += count;
}

SectorId TestLevel::addBox(std::string name, Vec2 min, Vec2 max, Heights heights) {
  const SectorId id = addSector(std::move(name), heights);
  addLoop(id, {min, {max.x, min.y}, max, {min.x, max.y}});
  return id;
}

void TestLevel::link(SectorId a, SectorId b) {
  for (std::size_t i = 0; i < level_[a].segmentCount; ++i) {
    for (std::size_t k = 0; k < level_[b].segmentCount; ++k) {
      if (wall(a, i).p0 != wall(b, k).p1 || wall(a, i).p1 != wall(b, k).p0) continue;
      wall(a, i).wall = Portal{b, texture(), texture()};
      wall(b, k).wall = Portal{a, texture(), texture()};
    }
  }
}

void TestLevel::connect(const std::vector<SectorId>& upper, const std::vector<SectorId>& lower) {
  const FlatPortalId id(level_.flatPortals.size());
  level_.flatPortals.push_back({"interface", level_[upper.front()].floor.z, upper, lower});
  for (const SectorId sector : upper) level_[sector].floor.flatPortal = id;
  for (const SectorId sector : lower) level_[sector].ceiling.flatPortal = id;
}

SegmentId TestLevel::wallId(SectorId sector, std::size_t index) const {
  return SegmentId(level_[sector].firstSegment.index() + index);
}

Segment& TestLevel::wall(SectorId sector, std::size_t index) {
  return level_[wallId(sector, index)];
}

LightSource& TestLevel::addLight(SectorId sector, Vec3 position, double intensity, double falloff) {
  LightSource light;
  light.position = position;
  light.sector = sector;
  light.intensity = intensity;
  light.falloff = falloff;
  level_.lights.push_back(light);
  return level_.lights.back();
}

Sprite& TestLevel::addSprite(SectorId sector, Vec3 position, Facing facing, Vec2 sizeMetres,
                             TextureMapping image) {
  Sprite sprite;
  sprite.position = position;
  sprite.sector = sector;
  sprite.facing = facing;
  sprite.frames = {{{image.texture, sizeMetres}}};
  sprite.thing = thingCount();
  level_.sprites.push_back(sprite);
  return level_.sprites.back();
}

Mesh& TestLevel::addMesh(SectorId sector, std::string name, const std::vector<MeshFace>& faces) {
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.position = faces.front().corners.front();
  mesh.sector = sector;
  mesh.thing = thingCount();
  mesh.firstFace = static_cast<std::uint32_t>(level_.meshFaces.size());
  mesh.faceCount = static_cast<std::uint32_t>(faces.size());
  level_.meshFaces.insert(level_.meshFaces.end(), faces.begin(), faces.end());
  level_.meshes.push_back(std::move(mesh));
  return level_.meshes.back();
}

const Level& TestLevel::finished() {
  for (Sector& sector : level_.sectors)
    for (Flat* flat : {&sector.floor, &sector.ceiling})
      if (flat->flatPortal) flat->texture.reset();
  CHECK(linkSurfaces(level_).empty(), "test levels have no faults");
  std::vector<MissingTexture> missing;
  geometry_ = deriveGeometry(level_, missing);
  CHECK(missing.empty(), "test levels have no faults");
  addThingSurfaces(level_, geometry_);
  CHECK(!addMeshSectors(level_, geometry_), "test levels have no faults");
  return level_;
}

}  // namespace hearth
