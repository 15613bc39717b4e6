#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "random_levels/places.h"

namespace hearth::random_levels {

/// A wall of a sector, from `a` to `b`.
struct WallOfSector {
  SectorIndex sector;
  const Wall* wall;
  Vec2 a;
  Vec2 b;

  Vec2 inward() const { return unit(turned90(b - a)); }
};

/// None where the wall is solid or a stack.
const PortalPiece* onlyPortal(const Wall& wall);

bool isPortal(const WallOfSector& at);
/// Stacks are not.
bool isSolid(const WallOfSector& at);

/// Of length 1, towards an angle in degrees.
Vec2 along(double angle);

/// Numbers from `low` to `high`.
struct Interval {
  double low;
  double high;
};

/// Finds places for things, most of them where the views look.
class ThingPlaces {
 public:
  ThingPlaces(Random& random, const Model& model, const std::vector<RandomView>& views);

  /// In the air of a sector above `p`, as near to that height as may be.
  std::optional<Place> put(SectorIndex s, Vec2 p, double z) const;
  /// Whether `put` would leave it on the floor.
  bool isOnFloor(const Place& place) const;

  /// Mostly the sector of a view, where a thing is likely to show.
  SectorIndex nearSector();

  /// A wall of such a sector for which `isRight`.
  template <typename IsRight>
  std::optional<WallOfSector> wallNear(IsRight&& isRight) {
    const SectorIndex s = nearSector();
    std::vector<WallOfSector> found;
    for (const WallOfSector& wall : walls_)
      if (wall.sector == s && length(wall.b - wall.a) > 0.2 && isRight(wall)) found.push_back(wall);
    if (found.empty()) return std::nullopt;
    return random_.pickFrom(found);
  }

  /// A point of the wall's sector so many metres before it; `share` is of the way along it.
  std::optional<Vec2> before(const WallOfSector& wall, Interval share, Interval metres);

  /// Up to 3 m before a view's eye, with its middle so far above its position.
  std::optional<Place> beforeEye(double middleAbove);

  /// A point of the map in a sector that has a flat portal.
  struct AtFlatPortal {
    SectorIndex sector;
    Vec2 p;
    double plane;  ///< the flat portal's height
  };
  std::optional<AtFlatPortal> atFlatPortal();

  std::optional<Place> behindMiddle();

 private:
  Random& random_;
  const Model& model_;
  const std::vector<RandomView>& views_;
  std::vector<WallOfSector> walls_;
};

}  // namespace hearth::random_levels
