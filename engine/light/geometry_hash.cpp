#include "light/geometry_hash.h"

#include <optional>
#include <string_view>
#include <variant>

#include "light/gather/area_lights.h"
#include "math/hash.h"

namespace hearth {

namespace {

/// Hashes sectors down to their sub-walls.
class GeometryHasher {
 public:
  GeometryHasher(Hash& hash, const PartNumbers& numbers) : hash_(hash), numbers_(numbers) {}

  void add(const Scene& scene, const Sector& sector) {
    const SectorGeometry& heights = scene.geometryOf(sector);
    addFlat(sector.floor, heights.zFloor, sector.floorSlope);
    addFlat(sector.ceiling, heights.zCeiling, sector.ceilingSlope);
    hash_.addWhole(sector.loops.size());
    for (const Loop& loop : sector.loops) hash_.addWhole(loop.count);
    for (const Segment& segment : scene.segmentsOf(sector)) addSegment(segment, heights);
  }

 private:
  enum FlatKind : std::uint64_t { Plain, Sky, FlatPortal, Sloped };
  enum WallKind : std::uint64_t { SolidWall, PortalWall, StackOfWalls, PortalWithMaskedMiddle };

  void addFlat(const Flat& flat, double z, const std::optional<Slope>& slope) {
    hash_.addReal(z);
    if (slope) {
      hash_.addWhole(Sloped);
      hash_.addPoint(slope->origin);
      hash_.addReal(slope->zAt0);
      hash_.addPoint(slope->gradient);
    } else if (flat.flatPortal) {
      hash_.addWhole(FlatPortal);
      hash_.addWhole(numbers_.ofFlatPortal(*flat.flatPortal));
    } else {
      hash_.addWhole(flat.isSky ? Sky : Plain);
    }
  }

  void addSegment(const Segment& segment, const SectorGeometry& heights) {
    hash_.addPoint(segment.p0);
    hash_.addPoint(segment.p1);
    if (const Stack* stack = std::get_if<Stack>(&segment.wall)) return addStack(*stack, heights);
    if (const Portal* portal = std::get_if<Portal>(&segment.wall)) return addWall(*portal);
    addWall(std::get<Solid>(segment.wall));
  }

  void addWall(const Solid&) { hash_.addWhole(SolidWall); }

  void addWall(const Portal& portal) {
    hash_.addWhole(portal.maskedMiddle ? PortalWithMaskedMiddle : PortalWall);
    hash_.addWhole(numbers_.ofSector(portal.next));
    if (!portal.maskedMiddle) return;
    const auto& [texture, repeat, offsetTexels, along, zRef] = *portal.maskedMiddle;
    hash_.addWhole(numbers_.ofHoles(texture));
    hash_.addPoint(repeat);
    hash_.addPoint(offsetTexels);
    hash_.addReal(along);
    hash_.addWhole(zRef ? 1 : 0);
    hash_.addReal(zRef.value_or(0));
  }

  void addStack(const Stack& stack, const SectorGeometry& heights) {
    hash_.addWhole(StackOfWalls);
    hash_.addWhole(stack.subWalls.size());
    for (std::size_t i = 0; i < stack.subWalls.size(); ++i) {
      hash_.addReal(stack.topOf(i, heights.zFloor, heights.zCeiling));
      std::visit([this](const auto& wall) { addWall(wall); }, stack.subWalls[i].kind);
    }
  }

  Hash& hash_;
  const PartNumbers& numbers_;
};

/// The name of a texture that shines; empty for others.
std::string_view shiningName(const Level& level, const AreaLights& lights, TextureId texture) {
  return lights.ofTexture(texture) ? level.textures[texture.index()] : std::string_view();
}

}  // namespace

std::uint64_t geometryHash(const Scene& scene, double texel) {
  const PartNumbers ids{[](SectorId id) { return id.value; },
                        [](FlatPortalId id) { return id.value; },
                        [](TextureId id) { return id.value; }};
  Hash hash;
  hash.addReal(texel);
  for (const TexelHoles& holes : scene.level().holes) addHoles(hash, holes);
  hash.addWhole(scene.level().sectors.size());
  for (const Sector& sector : scene.level().sectors) addGeometry(hash, scene, sector, ids);
  for (const Mesh& mesh : scene.level().meshes) {
    addMesh(hash, scene.level(), mesh);
    hash.addWhole(mesh.sector.value);
  }
  for (const Sprite& sprite : scene.level().sprites) {
    hash.addPoint(lightPointOf(scene, sprite));
    hash.addWhole(sprite.sector.value);
  }
  return hash.value();
}

void addGeometry(Hash& hash, const Scene& scene, const Sector& sector, const PartNumbers& numbers) {
  GeometryHasher(hash, numbers).add(scene, sector);
}

void addMesh(Hash& hash, const Level& level, const Mesh& mesh) {
  hash.addWhole((mesh.castsShadow ? 1 : 0) + (mesh.isTwoSided ? 2 : 0));
  hash.addWhole(mesh.faceCount);
  for (const MeshFace& face : level.facesOf(mesh))
    for (const Vec3 corner : face.corners) hash.addPoint(corner);
}

std::vector<std::uint64_t> hashesOfShining(const Level& level, const AreaLights& lights) {
  if (!lights.haveEmitters()) return {};
  std::vector<Hash> hashes(level.sectors.size());
  for (const Surface& surface : level.surfaces)
    if (canShine(surface.kind))
      hashes[surface.sector.index()].addText(shiningName(level, lights, surface.mapping.texture));
  std::vector<std::uint64_t> values;
  for (const Hash& hash : hashes) values.push_back(hash.value());
  return values;
}

void addShining(Hash& hash, const Level& level, const AreaLights& lights, const Mesh& mesh) {
  if (!lights.haveShiningFaces()) return;
  for (const MeshFace& face : level.facesOf(mesh))
    hash.addText(shiningName(level, lights, face.texture));
}

void addReflectances(Hash& hash, const Level& level) {
  const auto add = [&](TextureId texture) {
    if (texture.index() < level.reflectances.size())
      hash.addPoint(level.reflectances[texture.index()]);
  };
  for (const Surface& surface : level.surfaces) add(surface.mapping.texture);
  for (const MeshFace& face : level.meshFaces) add(face.texture);
}

void addHoles(Hash& hash, const TexelHoles& holes) {
  if (holes.bits().empty()) return;
  hash.addWhole(static_cast<std::uint64_t>(holes.width()));
  std::uint64_t word = 1;
  for (const bool isHole : holes.bits()) {
    word = word << 1 | (isHole ? 1 : 0);
    if (word >> 63 == 0) continue;
    hash.addWhole(word);
    word = 1;
  }
  hash.addWhole(word);
}

void addLight(Hash& hash, const LightSource& light, std::uint64_t sectorNumber) {
  // By name, so that no new member is forgotten.
  const auto& [position, sector, intensity, falloff, curve, color, radius, spot, sun, isSky,
               isBounced, texture] = light;
  hash.addPoint(position);
  hash.addWhole(light.hasPlace() ? sectorNumber : 0);
  for (const double number : {intensity, falloff, radius}) hash.addReal(number);
  hash.addWhole(curve.size());
  for (const auto& [distance, level] : curve) hash.addPoint(Vec2{distance, level});
  for (const std::uint8_t channel : color) hash.addWhole(channel);
  if (spot)
    for (const double number : {spot->angle(), spot->pitch(), spot->inner(), spot->outer()})
      hash.addReal(number);
  if (sun)
    for (const double number : {sun->angle(), sun->pitch(), sun->size()}) hash.addReal(number);
  if (isSky) hash.addText("sky");
  if (isBounced) hash.addText("bounced");
  if (light.isEmitter()) hash.addText("emitter " + texture);
}

}  // namespace hearth
