#pragma once

#include <optional>

#include "level/scene.h"
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

/// The segment as one, if it covers some of these columns of a screen that is so wide.
std::optional<SegmentFront> frontOf(const Scene& scene, const Projection& projection,
                                    const Segment& segment, int width, ColumnRange columns);

}  // namespace hearth
