#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "load/link/link.h"
#include "math/box_tree.h"

namespace hearth {

/// Finds the sectors behind a wall in plan, for advice on portals that lead nowhere. Expects the
/// sectors' heights.
class WallsBehind {
 public:
  explicit WallsBehind(const Linking& linking) : linking_(linking) {}

  /// Other sectors at the heights of `sector` that have a wall along `from` to `to` which runs the
  /// opposite way, in the order of the file.
  std::vector<SectorId> sectors(SectorId sector, Vec2 from, Vec2 to);

 private:
  bool runsBackAlong(const Edge& edge, Vec2 from, Vec2 to) const;
  bool overlapInHeight(SectorId a, SectorId b) const;

  const Linking& linking_;
  std::optional<BoxTree> edges_;  ///< built when it is first needed
};

/// An end of a wall that a vertex of another sector was to lie on.
struct MissedPoint {
  Vec2 point;
  Vec2 vertex;
  double distance;  ///< metres
};

/// The first end of `from` to `to` that lies on no wall of the sector, though a vertex of it is
/// near.
std::optional<MissedPoint> missedPoint(const Outlines& outlines, SectorId sector, Vec2 from,
                                       Vec2 to);

}  // namespace hearth
