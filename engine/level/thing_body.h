#pragma once

#include "level/convex_outline.h"

namespace hearth {

/// What of a thing is solid to the player: an upright prism or cylinder.
struct ThingBody {
  ConvexOutline outline;
  double radius =
      0;  ///< metres by which it reaches beyond its outline; of a cylinder round a point
  double zBottom = 0;
  double zTop = 0;
};

}  // namespace hearth
