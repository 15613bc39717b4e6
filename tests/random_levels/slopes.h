#pragma once

#include "random_levels/model.h"

namespace hearth::random_levels {

/// Puts wedges on about `fraction` of the floors and ceilings that may have one, some of them in
/// one plane with a neighbour's. Needs the loops.
void makeSlopes(Random& random, Model& model, double fraction);

}  // namespace hearth::random_levels
