#pragma once

#include <set>
#include <vector>

#include "random_levels/places.h"

namespace hearth::random_levels {

/// Gives some of the lights a colour, and some a curve, and notes which.
void makeColorsAndCurves(Random& random, std::vector<RandomLight>& lights,
                         std::set<Feature>& features);

}  // namespace hearth::random_levels
