#pragma once

#include <vector>

#include "import/doom/map.h"

namespace hearth::doom {

/// The positions of a map's moving sectors.
enum class Doors : std::uint8_t {
  Open,   ///< doors are open, lifts are down
  Closed  ///< as the map begins
};

struct Heights {
  int floor;    ///< map units
  int ceiling;  ///< map units
};

/// By sector of the map.
std::vector<Heights> heightsOf(const Map& map, Doors doors);

}  // namespace hearth::doom
