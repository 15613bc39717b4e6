#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/segment_columns.h"
#include "render/span.h"
#include "render/strip.h"

namespace hearth {

/// Spans of one surface in columns of one strip, at most one in each column. They are painted
/// together: each column is a lane of a register.
struct SpanGroup {
  SurfaceId surface;
  int firstColumn;
  int rowBegin;                                    ///< of all spans: the first row ...
  int rowEnd;                                      ///< ... and the one behind the last
  std::array<const Span*, Strip::kColumns> spans;  ///< by column; null where there is none
};

/// The spans of some of a frame's columns, in groups, by the strips that they lie in. Keeps its
/// memory from frame to frame.
class SpanGroups {
 public:
  /// `columns` begin with a strip. Keeps pointers to the spans.
  void group(const VisibleSpans& found, ColumnRange columns);

  /// The number of pixels of a strip that show a surface without holes: no two such spans share a
  /// pixel.
  int pixelsOf(int strip) const { return pixels_[static_cast<std::size_t>(strip - firstStrip_)]; }

  /// The groups of one strip of the frame, those of masked middle textures last. In each column
  /// these come from far to near.
  std::span<const SpanGroup> of(int strip) const {
    const auto index = static_cast<std::size_t>(strip - firstStrip_);
    return std::span(sorted_).subspan(begin_[index], begin_[index + 1] - begin_[index]);
  }

 private:
  SpanGroup* groupFor(const Span& span, std::size_t strip, bool staysInFront);
  void sortByStrip();

  /// A group while they are found, with the one before it in its strip.
  struct Found {
    SpanGroup group;
    std::uint32_t strip;
    std::uint32_t before;
  };

  int firstStrip_ = 0;
  std::vector<int> pixels_;          ///< by strip
  std::vector<std::uint32_t> last_;  ///< by strip: its last group in found_
  std::vector<Found> found_;
  std::vector<SpanGroup> sorted_;
  std::vector<std::size_t> begin_;  ///< of the i-th strip are [begin_[i], begin_[i + 1])
};

}  // namespace hearth
