#include "import/doom/heights.h"

#include "import/doom/destinations.h"

namespace hearth::doom {

std::vector<Heights> heightsOf(const Map& map, Doors doors) {
  std::vector<Heights> heights;
  for (const Sector& sector : map.sectors) heights.push_back({sector.floor, sector.ceiling});
  if (doors != Doors::Open) return heights;
  const Destinations destinations(map);
  for (const std::uint32_t door : destinations.doors()) {
    int& z = heights[door].ceiling;
    z = destinations.heightFor(Destination::DoorTop, door).value_or(z);
  }
  const auto isLift = [](const LineType& type) { return type.kind == LineKind::Lift; };
  for (const std::uint32_t lift : destinations.movedBy(isLift))
    heights[lift].floor = destinations.heightFor(Destination::LowestFloor, lift).value();
  return heights;
}

}  // namespace hearth::doom
