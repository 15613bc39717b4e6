#pragma once

#include <vector>

#include "import/doom/map.h"

namespace hearth::doom {

/// What becomes of what moves in a map: doors, lifts, floors and ceilings.
enum class Doors : std::uint8_t {
  Moving,  ///< it stands as the map begins, and moves
  Open,    ///< doors are open and lifts are down for ever
  Closed   ///< all stands for ever as the map begins
};

struct Heights {
  int floor;    ///< map units
  int ceiling;  ///< map units
};

/// By sector of the map.
std::vector<Heights> heightsOf(const Map& map, Doors doors);

}  // namespace hearth::doom
