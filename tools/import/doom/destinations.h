#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "import/doom/line_types.h"
#include "import/doom/map.h"

namespace hearth::doom {

/// Where the flats of a map's sectors go. All heights are those with which the map begins, in map
/// units: Doom takes those of the moment at which a line is used.
class Destinations {
 public:
  /// The map must outlive it.
  explicit Destinations(const Map& map);

  /// The sectors that a line of this type moves: the one behind it, or those with its tag.
  std::vector<std::uint32_t> sectorsOf(const Line& line, const LineType& type) const;
  /// Those that the lines of all types that count move.
  std::set<std::uint32_t> movedBy(bool (*counts)(const LineType&)) const;
  /// Those that lines open.
  const std::set<std::uint32_t>& doors() const { return doors_; }
  /// None where nothing is around that tells it, or it is none that a single height says.
  std::optional<int> heightFor(Destination destination, std::uint32_t sector) const;
  /// On both sides of a line with this sector.
  const std::set<std::uint32_t>& neighboursOf(std::uint32_t sector) const {
    return neighbours_[sector];
  }

 private:
  void findNeighbours();
  std::optional<int> doorTop(std::uint32_t sector) const;
  std::optional<int> nextFloor(std::uint32_t sector) const;
  std::optional<int> highestFloor(std::uint32_t sector) const;
  std::optional<int> aboveHighestFloor(std::uint32_t sector) const;
  std::optional<int> highestCeiling(std::uint32_t sector) const;
  int lowestFloor(std::uint32_t sector) const;
  int lowestCeiling(std::uint32_t sector) const;

  const Map& map_;
  std::vector<std::set<std::uint32_t>> neighbours_;  ///< by sector
  std::map<std::uint16_t, std::vector<std::uint32_t>> tagged_;
  std::set<std::uint32_t> doors_;
};

}  // namespace hearth::doom
