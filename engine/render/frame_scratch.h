#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "render/segment_columns.h"
#include "render/span_groups.h"
#include "render/strip.h"
#include "render/visibility_scratch.h"

namespace hearth {

/// Neighbouring columns of a frame, whose spans one thread finds.
struct FrameColumns {
  ColumnRange range{};  ///< begins with a strip
  VisibilityScratch visibility;

  const VisibleSpans& found() const { return visibility.found; }
};

/// The memory in which frames are drawn. A caller that keeps it from frame to frame takes no memory
/// anew. Each thread that draws frames needs its own. No frame depends on an earlier one.
struct FrameScratch {
  std::vector<FrameColumns> parts;        ///< with the spans of the last frame, from left to right
  std::vector<double> raySlopes;          ///< of the centres of rows, see Projection::raySlopeAt
  std::vector<StripsTogether> strips;     ///< for each part that threads take
  std::vector<PaintStats> stripsPainted;  ///< by the same parts
  PaintStats painted;                     ///< in the last frame

  /// The work of finding the spans of the last frame. Sectors, windows, segments, sprites and faces
  /// count once for each part in which they are seen.
  FrameStats found() const {
    FrameStats sum;
    for (const FrameColumns& part : parts) sum += part.found().stats;
    return sum;
  }

  /// Calls `use(group)` for the groups of spans of a strip of the last frame, each a SpanGroup or a
  /// FaceGroup, in an order in which they can be painted.
  template <typename Use>
  void forEachGroup(int strip, Use&& use) const {
    partOf(strip).found().forEachGroup(strip, use);
  }

  /// Whether the level's spans cover every pixel of a strip of so many rows. As they never overlap,
  /// they do if they have as many pixels.
  bool isFilled(int strip, int rows) const {
    const FrameColumns& part = partOf(strip);
    const int columns = std::min(Strip::kColumns, part.range.end - strip * Strip::kColumns);
    return part.found().level.pixelsOf(strip) ==
           static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }

  /// Calls `use(span)` for all spans of the last frame.
  template <typename Use>
  void forEachSpan(Use&& use) const {
    for (const FrameColumns& part : parts) part.found().forEachSpan(use);
  }

 private:
  const FrameColumns& partOf(int strip) const {
    const auto isLeftOf = [](const FrameColumns& part, int column) {
      return part.range.end <= column;
    };
    return *std::lower_bound(parts.begin(), parts.end(), strip * Strip::kColumns, isLeftOf);
  }
};

}  // namespace hearth
