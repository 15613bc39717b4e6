#pragma once

#include "lint/lint.h"

namespace hearth {

/// The description of a wall or, in a stack, of its sub-wall at a height.
struct AuthoredWall {
  Place place;
  const SolidDescription* solid = nullptr;    ///< either this ...
  const PortalDescription* portal = nullptr;  ///< ... or that
};

/// `z`: absolute, from the part's bottom on.
AuthoredWall authoredWallAt(const LintedLevel& linted, SegmentId segment, double z);

/// The place in the file of the wall, sub-wall, flat or slope that a surface belongs to.
Place placeOf(const LintedLevel& linted, SurfaceId surface);

}  // namespace hearth
