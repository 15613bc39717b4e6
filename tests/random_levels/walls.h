#pragma once

#include "random_levels/model.h"

namespace hearth::random_levels {

struct WallStyle {
  double stackFraction = 0.15;  ///< of the borders between sectors, that get stacks
  double mergeFraction = 0.5;   ///< of the vertices on a straight line, that a loop leaves out
  double wrongWinding = 0.03;   ///< of the loops
};

/// Draws the loops of all sectors, and puts solids, portals and stacks into their walls.
void makeWalls(Random& random, Model& model, const WallStyle& style);

}  // namespace hearth::random_levels
