#pragma once

#include <map>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "import/doom/findings.h"
#include "import/doom/heights.h"
#include "import/doom/map.h"
#include "import/doom/movers.h"
#include "import/doom/regions.h"

namespace hearth::doom {

/// The air of a region.
struct Space {
  double floor;    ///< metres
  double ceiling;  ///< metres
  bool isUnderSky;
  bool isOverSky;
};

/// The part of a half-edge that shows a texture: all of it, the closed parts above and below a
/// portal's opening, or the texture that hangs in the opening.
enum class WallPart : std::uint8_t { Solid, Upper, Lower, Middle };

struct ShownPart {
  WallPart part;
  double bottom;        ///< metres
  double top;           ///< metres
  const Face* face;     ///< whose line it is: that of the side behind, if this one has none
  std::string texture;  ///< kNoTexture: the map has none for it
};

/// A map as enclosed regions with heights and names.
class GroundPlan {
 public:
  /// The map must outlive it. The error is one sentence.
  static tl::expected<GroundPlan, std::string> of(const Map& map, Doors doors, Findings& findings);

  const Map& map() const { return *map_; }
  const std::vector<Region>& regions() const { return plane_.regions; }
  const HalfEdge& halfEdge(std::uint32_t h) const { return plane_.halfEdges[h]; }
  const HalfEdge& behind(std::uint32_t h) const { return plane_.halfEdges[Regions::twinOf(h)]; }
  std::optional<std::uint32_t> regionAt(Vec2 p) const { return plane_.regionAt(p); }
  bool contains(std::uint32_t region, Vec2 p) const { return plane_.contains(region, p); }

  const Sector& sectorOf(std::uint32_t region) const {
    return map_->sectors[plane_.regions[region].sector];
  }
  /// The parts of a sector of the map.
  const std::vector<std::uint32_t>& regionsOf(std::uint32_t sector) const {
    return regionsOf_[sector];
  }
  /// The sector's number; of a sector in several parts `N`, `N.2`, `N.3` ...
  const std::string& nameOf(std::uint32_t region) const { return names_[region]; }
  Space spaceOf(std::uint32_t region) const { return spaceAt(region, {}); }

  const MapMovers& movers() const { return movers_; }
  /// Those of either flat.
  const std::vector<std::size_t>& moversOf(std::uint32_t region) const {
    return moversOf_[plane_.regions[region].sector];
  }
  /// Those that a line starts.
  std::vector<std::size_t> startedBy(std::uint32_t line) const;
  /// What is air wherever movers stand.
  Space lastingSpaceOf(std::uint32_t region) const;

  bool isPortal(std::uint32_t h) const { return plane_.isPortal(h); }
  /// From the bottom to the top.
  std::vector<ShownPart> shownParts(std::uint32_t h) const { return partsAt(h, {}); }
  /// And those that show only while movers are at other ends.
  std::vector<ShownPart> partsAtAnyEnd(std::uint32_t h) const;

 private:
  GroundPlan(const Map& map, Regions plane, std::vector<Heights> heights, MapMovers movers);
  void nameRegions();
  void indexMovers();
  /// While these movers are at their other ends.
  Space spaceAt(std::uint32_t region, std::span<const std::size_t> moved) const;
  std::vector<ShownPart> partsAt(std::uint32_t h, std::span<const std::size_t> moved) const;
  bool hasMaskedMiddle(std::uint32_t h) const;
  ShownPart solidPart(const Face& face, const Space& own) const;

  const Map* map_;
  Regions plane_;
  std::vector<Heights> heights_;  ///< by sector of the map
  MapMovers movers_;
  std::vector<std::vector<std::size_t>> moversOf_;               ///< by sector of the map
  std::map<std::uint32_t, std::vector<std::size_t>> startedBy_;  ///< by line
  std::vector<std::vector<std::uint32_t>> regionsOf_;            ///< by sector of the map
  std::vector<std::string> names_;                               ///< by region
};

}  // namespace hearth::doom
