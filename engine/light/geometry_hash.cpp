#include "light/geometry_hash.h"

#include <bit>
#include <optional>
#include <variant>

namespace hearth {

namespace {

/// FNV-1a of 64 bits (Fowler, Noll, Vo) over numbers of 8 bytes, the low byte first.
class Hash {
 public:
  std::uint64_t value() const { return value_; }

  void addWhole(std::uint64_t number) {
    constexpr std::uint64_t kPrime = 0x100000001b3;
    for (int shift = 0; shift < 64; shift += 8)
      value_ = (value_ ^ ((number >> shift) & 0xff)) * kPrime;
  }

  void addReal(double number) {
    addWhole(std::bit_cast<std::uint64_t>(number + 0.0));  // -0 and 0 are one place
  }

  void addPoint(Vec2 p) {
    addReal(p.x);
    addReal(p.y);
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

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
