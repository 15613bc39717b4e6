#include "light/geometry_hash.h"

#include <optional>
#include <variant>

#include "math/hash.h"

namespace hearth {

namespace {

/// Hashes the level from its sectors down to its sub-walls.
class GeometryHasher {
 public:
  std::uint64_t hash(const Level& level, double texel) {
    hash_.addReal(texel);
    hash_.addWhole(level.sectors.size());
    for (const Sector& sector : level.sectors) {
      addFlat(sector.floor, sector.floorSlope);
      addFlat(sector.ceiling, sector.ceilingSlope);
      hash_.addWhole(sector.loops.size());
      for (const Loop& loop : sector.loops) hash_.addWhole(loop.count);
      for (const Segment& segment : level.segmentsOf(sector)) addSegment(segment);
    }
    return hash_.value();
  }

 private:
  enum FlatKind : std::uint64_t { Plain, Sky, FlatPortal, Sloped };
  enum WallKind : std::uint64_t { SolidWall, PortalWall, StackOfWalls };

  void addFlat(const Flat& flat, const std::optional<Slope>& slope) {
    hash_.addReal(flat.z);
    if (slope) {
      hash_.addWhole(Sloped);
      hash_.addPoint(slope->origin);
      hash_.addReal(slope->zAt0);
      hash_.addPoint(slope->gradient);
    } else if (flat.interface) {
      hash_.addWhole(FlatPortal);
      hash_.addWhole(flat.interface->value);
    } else {
      hash_.addWhole(flat.parallax ? Sky : Plain);
    }
  }

  void addSegment(const Segment& segment) {
    hash_.addPoint(segment.p0);
    hash_.addPoint(segment.p1);
    std::visit([this](const auto& wall) { addWall(wall); }, segment.kind);
  }

  void addWall(const Solid&) { hash_.addWhole(SolidWall); }

  void addWall(const Portal& portal) {
    hash_.addWhole(PortalWall);
    hash_.addWhole(portal.next.value);
  }

  void addWall(const Stack& stack) {
    hash_.addWhole(StackOfWalls);
    hash_.addWhole(stack.subWalls.size());
    for (const SubWall& subWall : stack.subWalls) {
      hash_.addReal(subWall.zTop);
      std::visit([this](const auto& wall) { addWall(wall); }, subWall.kind);
    }
  }

  Hash hash_;
};

}  // namespace

std::uint64_t geometryHash(const Level& level, double texel) {
  return GeometryHasher().hash(level, texel);
}

}  // namespace hearth
