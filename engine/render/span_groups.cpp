#include "render/span_groups.h"

#include <algorithm>
#include <numeric>

namespace hearth {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// As many groups of a strip are looked at. Neighbouring columns of a sector have fewer.
constexpr int kLookedAt = 12;

bool overlapInRows(const SpanGroup& group, const Span& span) {
  return span.rowBegin < group.rowEnd && group.rowBegin < span.rowEnd;
}

}  // namespace

void SpanGroups::group(const VisibleSpans& found, ColumnRange columns) {
  const auto strips = static_cast<std::size_t>(Strip::countIn(columns.end - columns.begin));
  firstStrip_ = columns.begin / Strip::kColumns;
  pixels_.assign(strips, 0);
  last_.assign(strips, kNone);
  found_.clear();
  const std::size_t withoutHoles = found.spans.size() - found.stats.maskedMiddleSpans;
  for (std::size_t i = 0; i < found.spans.size(); ++i) {
    const Span& span = found.spans[i];
    const auto strip = static_cast<std::size_t>(span.column / Strip::kColumns - firstStrip_);
    if (i < withoutHoles) pixels_[strip] += span.rowEnd - span.rowBegin;
    SpanGroup& group = *groupFor(span, strip, i >= withoutHoles);
    group.rowBegin = std::min(group.rowBegin, span.rowBegin);
    group.rowEnd = std::max(group.rowEnd, span.rowEnd);
    group.spans[static_cast<std::size_t>(span.column % Strip::kColumns)] = &span;
  }
  sortByStrip();
}

/// A group of the span's surface that has no span in its column yet, or a new one. Spans in front
/// of others stay behind them: `staysInFront` of all that are found in its column already.
SpanGroup* SpanGroups::groupFor(const Span& span, std::size_t strip, bool staysInFront) {
  const auto lane = static_cast<std::size_t>(span.column % Strip::kColumns);
  std::uint32_t index = last_[strip];
  for (int i = 0; i < kLookedAt && index != kNone; ++i, index = found_[index].before) {
    SpanGroup& group = found_[index].group;
    if (group.spans[lane]) {
      if (staysInFront) break;
    } else if (group.surface == span.surface && overlapInRows(group, span)) {
      return &group;
    }
  }
  found_.push_back({{span.surface,
                     span.column / Strip::kColumns * Strip::kColumns,
                     span.rowBegin,
                     span.rowEnd,
                     {}},
                    static_cast<std::uint32_t>(strip),
                    last_[strip]});
  last_[strip] = static_cast<std::uint32_t>(found_.size() - 1);
  return &found_.back().group;
}

/// A counting sort.
void SpanGroups::sortByStrip() {
  begin_.assign(pixels_.size() + 2, 0);
  for (const Found& found : found_) ++begin_[found.strip + 2];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  sorted_.resize(found_.size());
  for (const Found& found : found_) sorted_[begin_[found.strip + 1]++] = found.group;
}

}  // namespace hearth
