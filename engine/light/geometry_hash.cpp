#include "light/geometry_hash.h"

#include <optional>
#include <variant>

#include "math/hash.h"

namespace hearth {

namespace {

/// Hashes sectors down to their sub-walls.
class GeometryHasher {
 public:
  GeometryHasher(Hash& hash, const PartNumbers& numbers) : hash_(hash), numbers_(numbers) {}

  void add(const Level& level, const Sector& sector) {
    addFlat(sector.floor, sector.floorSlope);
    addFlat(sector.ceiling, sector.ceilingSlope);
    hash_.addWhole(sector.loops.size());
    for (const Loop& loop : sector.loops) hash_.addWhole(loop.count);
    for (const Segment& segment : level.segmentsOf(sector)) addSegment(segment);
  }

 private:
  enum FlatKind : std::uint64_t { Plain, Sky, FlatPortal, Sloped };
  enum WallKind : std::uint64_t { SolidWall, PortalWall, StackOfWalls, PortalWithMaskedMiddle };

  void addFlat(const Flat& flat, const std::optional<Slope>& slope) {
    hash_.addReal(flat.z);
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

  void addSegment(const Segment& segment) {
    hash_.addPoint(segment.p0);
    hash_.addPoint(segment.p1);
    std::visit([this](const auto& wall) { addWall(wall); }, segment.kind);
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

  void addWall(const Stack& stack) {
    hash_.addWhole(StackOfWalls);
    hash_.addWhole(stack.subWalls.size());
    for (const SubWall& subWall : stack.subWalls) {
      hash_.addReal(subWall.zTop);
      std::visit([this](const auto& wall) { addWall(wall); }, subWall.kind);
    }
  }

  Hash& hash_;
  const PartNumbers& numbers_;
};

}  // namespace

std::uint64_t geometryHash(const Level& level, double texel) {
  const PartNumbers ids{[](SectorId id) { return id.value; },
                        [](FlatPortalId id) { return id.value; },
                        [](TextureId id) { return id.value; }};
  Hash hash;
  hash.addReal(texel);
  for (const TexelHoles& holes : level.holes) addHoles(hash, holes);
  hash.addWhole(level.sectors.size());
  for (const Sector& sector : level.sectors) addGeometry(hash, level, sector, ids);
  return hash.value();
}

void addGeometry(Hash& hash, const Level& level, const Sector& sector, const PartNumbers& numbers) {
  GeometryHasher(hash, numbers).add(level, sector);
}

void addHoles(Hash& hash, const TexelHoles& holes) {
  if (holes.all().empty()) return;
  hash.addWhole(static_cast<std::uint64_t>(holes.width()));
  std::uint64_t word = 1;
  for (const bool isHole : holes.all()) {
    word = word << 1 | (isHole ? 1 : 0);
    if (word >> 63 == 0) continue;
    hash.addWhole(word);
    word = 1;
  }
  hash.addWhole(word);
}

void addLight(Hash& hash, const LightSource& light, std::uint64_t sectorNumber) {
  // By name, so that no new member is forgotten.
  const auto& [position, sector, intensity, falloff, curve, color, radius] = light;
  hash.addPoint(position);
  hash.addWhole(sectorNumber);
  for (const double number : {intensity, falloff, radius}) hash.addReal(number);
  hash.addWhole(curve.size());
  for (const auto& [distance, level] : curve) hash.addPoint(Vec2{distance, level});
  for (const std::uint8_t channel : color) hash.addWhole(channel);
}

}  // namespace hearth
