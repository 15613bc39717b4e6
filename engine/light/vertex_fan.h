#pragma once

#include <span>
#include <utility>
#include <vector>

#include "level/level.h"

namespace hearth {

/// Which segments begin or end at a vertex: neighbours across walls and sectors.
class VertexFan {
 public:
  explicit VertexFan(const Level& level);

  struct Spoke {
    Vec2 vertex;
    SegmentId segment;
    bool startsHere;  ///< else it ends here
  };

  std::span<const Spoke> at(Vec2 vertex) const;

  /// Segments above or below this one, in its plane and with its ends, that a flat portal of its
  /// sector leads to. Linking cuts both sides of flat portals alike.
  std::vector<SegmentId> acrossFlatPortals(SegmentId id) const;

  /// True when one can go round `vertex` from sector `a` to sector `b` through openings that share
  /// some height with (zBottom, zTop); a sector is always joined to itself.
  bool joined(Vec2 vertex, SectorId a, SectorId b, double zBottom, double zTop) const;

  /// The parts of (zBottom, zTop), in metres and rising, at whose every height that holds.
  std::vector<std::pair<double, double>> joinedHeights(Vec2 vertex, SectorId a, SectorId b,
                                                       double zBottom, double zTop) const;

 private:
  const Level& level_;
  std::vector<Spoke> spokes_;  ///< sorted by vertex
};

}  // namespace hearth
