#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "import/doom/findings.h"
#include "import/doom/map.h"
#include "import/doom/pieces.h"

namespace hearth::doom {

/// One of the two ways along a piece of a line. The space in front of it is the region that it
/// bounds; behind it is what its twin bounds.
struct HalfEdge {
  Vec2 from;                            ///< metres
  Vec2 to;                              ///< metres
  std::optional<Face> face;             ///< none where the map says nothing of this side
  std::optional<std::uint32_t> region;  ///< none: solid rock
};

/// A connected part of the map's plane that lines enclose and none divides: a sector of Hearth.
struct Region {
  std::uint32_t sector;  ///< of the map
  /// Half-edges by index. The first loop is the border; no loop comes to a point twice.
  std::vector<std::vector<std::uint32_t>> loops;
};

struct Regions {
  std::vector<HalfEdge> halfEdges;
  std::vector<Region> regions;

  static constexpr std::uint32_t twinOf(std::uint32_t halfEdge) { return halfEdge ^ 1U; }
  /// The region in which a point lies. One on a line is in exactly one of the two beside it.
  std::optional<std::uint32_t> regionAt(Vec2 p) const;
  bool contains(std::uint32_t region, Vec2 p) const;
  /// Whether a half-edge is open. It has a region before it.
  bool isPortal(std::uint32_t halfEdge) const;
};

/// Finds out of which regions a map consists, whatever its sides say: sectors that are not closed,
/// sides that name the wrong sector and lines that divide nothing are found by what encloses what.
/// A region is of the sector that most of its outline's length names. `starters` are lines that
/// divide a region even if they lie within one sector: who crosses them starts something. The error
/// is one sentence.
tl::expected<Regions, std::string> findRegions(const Map& map,
                                               const std::set<std::uint32_t>& starters,
                                               Findings& findings);

}  // namespace hearth::doom
