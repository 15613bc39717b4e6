#pragma once

#include <set>
#include <vector>

#include "random_levels/places.h"

namespace hearth::random_levels {

/// Makes some of the lights spots, and notes which kinds.
void makeSpots(Random& random, std::vector<RandomLight>& lights, std::set<Feature>& features);

}  // namespace hearth::random_levels
