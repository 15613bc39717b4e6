#pragma once

#include "lint/lint.h"

namespace hearth {

/// What the file says of a wall or, in a stack, of the one of its walls at a height.
struct DescribedPart {
  Place place;
  const SolidDescription* solid = nullptr;    ///< either this ...
  const PortalDescription* portal = nullptr;  ///< ... or that
};

/// `z`: absolute, from the part's bottom on.
DescribedPart describedPart(const LintedLevel& linted, SegmentId segment, double z);

/// Where the file has what a surface belongs to: a wall, a part of a stack, a flat or a slope.
Place placeOf(const LintedLevel& linted, SurfaceId surface);

}  // namespace hearth
