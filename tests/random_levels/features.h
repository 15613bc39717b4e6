#pragma once

#include <set>

#include "random_levels/feature.h"
#include "random_levels/model.h"

namespace hearth::random_levels {

/// What the sectors hold, found by looking at the finished model rather than by trusting the
/// functions that made it. Spellings, lights and views are not in it.
std::set<Feature> featuresOf(const Model& model);

}  // namespace hearth::random_levels
