#pragma once

#include "level/scene.h"
#include "light/rays/shaft_hull.h"

namespace hearth {

/// Whether rays go on beyond skies, or end there.
enum class SkyIs { Passed, TheEnd };

/// What an opening of a wall lets through of the rays of a shaft.
struct ShaftPassage {
  bool isShut = false;  ///< none
  bool isOpen = true;   ///< all
};

/// `slice` is what the shaft's hull has of the wall.
ShaftPassage passageThrough(const Scene& scene, const Sector& sector, const Segment& wall,
                            const LightOpening& opening, const ShaftHull::Slice& slice, SkyIs sky);

/// Whether no ray is in the sector any more where it would meet its wall: all have left through a
/// flat portal, or ended in its sky.
bool haveLeftBefore(const Scene& scene, const Sector& sector, const Segment& wall,
                    const ShaftHull::Slice& slice, SkyIs sky);

/// The lines along a stretch of a wall that its sector's air ends at.
struct AirLines {
  EndHeights bottom;
  EndHeights top;
};
/// `from`, `to`: fractions of the way from the wall's p0 to p1.
AirLines airAlong(const Scene& scene, const Segment& wall, double from, double to);

}  // namespace hearth
