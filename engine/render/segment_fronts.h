#pragma once

#include "level/scene.h"
#include "render/by_sector.h"
#include "render/camera.h"
#include "render/segment_columns.h"

namespace hearth {

/// A segment whose front covers columns of the screen.
struct SegmentFront {
  SegmentId segment;
  bool hasLevelAir;     ///< no height changes along it, so it shows the same in all its columns
  ColumnRange columns;  ///< not empty
  SegmentMeetings meetings;
};

using SegmentFronts = BySector<SegmentFront>;

/// Finds those of another sector that cover some of these columns of a screen that is so wide.
void findFronts(const Scene& scene, const Projection& projection, SectorId sector, int width,
                ColumnRange columns, SegmentFronts& fronts);

}  // namespace hearth
