#pragma once

#include "random_levels/model.h"

namespace hearth::random_levels {

struct StoreyStyle {
  std::size_t groundSectors = 6;
  std::size_t chainLinks = 0;  ///< the first faces that become sectors of their own, in a row
  double voidFraction = 0;     ///< of the cells, that stay solid
  std::size_t storeys = 1;
  double skyFraction = 0;       ///< of the ceilings that may be sky
  double skyFloorFraction = 0;  ///< of the floors that may be sky
  bool hasDoors = false;
  bool hasHyphens = false;
};

/// Shares the faces of the mesh out among sectors, storey upon storey, and gives these their
/// names, heights, flat portals and skies. Loops stay empty. No sectors where the mesh leaves room
/// for none.
Model makeStoreys(Random& random, Mesh mesh, const StoreyStyle& style);

}  // namespace hearth::random_levels
