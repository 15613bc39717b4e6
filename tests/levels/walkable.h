#pragma once

#include <set>
#include <string>
#include <vector>

#include "level/scene.h"

namespace hearth::test {

/// What a walker asks of a level, in metres.
struct Gait {
  double stepHeight;       ///< the highest it climbs
  double radius;           ///< of the body
  double headroom = 1.9;   ///< of every doorway, and of where it stands
  double doorWidth = 0.8;  ///< of every doorway
  double steepest = 1;     ///< rise per metre of slopes that it stands on
};

/// For each sector, by its index, those that a walker enters from it: through portals, and down
/// through flat portals. It may drop any height.
using Ways = std::vector<std::set<std::size_t>>;
Ways waysOf(const Scene& scene, const Gait& gait);

/// The same ways, walked backwards.
Ways reversed(const Ways& ways);

/// All sectors that the ways lead to from one, itself included.
std::set<std::size_t> reachableFrom(const Ways& ways, std::size_t start);

/// Whether a body can stand in the sector without reaching into another: not on a parapet, in a
/// window, on a steep roof or in the sky.
bool hasRoom(const Scene& scene, const Sector& sector, const Gait& gait);

}  // namespace hearth::test
