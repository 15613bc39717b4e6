#include "render/span_groups.h"

#include <algorithm>
#include <limits>

namespace hearth {

namespace {

/// The search for a group to join stops after so many of the strip's last groups. Neighbouring
/// columns of a sector have fewer.
constexpr int kLookedAt = 12;

/// Rows [begin, end).
struct Rows {
  int begin = std::numeric_limits<int>::max();
  int end = 0;
};

/// Those between the first and the last of all lanes.
Rows allRows(const LaneRowRanges& rows) {
  Rows all;
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) {
    all.begin = std::min(all.begin, rows.has(lane) ? rows.begin[lane] : all.begin);
    all.end = std::max(all.end, rows.has(lane) ? rows.end[lane] : 0);
  }
  return all;
}

}  // namespace

void SpanGroups::clear(int firstStrip, int strips) {
  firstStrip_ = firstStrip;
  strips_.assign(static_cast<std::size_t>(strips), {});
  links_.clear();
  facesCount_ = 0;
  spans_ = 0;
}

SpanGroups::Added SpanGroups::add(SurfaceId surface, int strip, const LaneRowRanges& rows) {
  return add(surface.value, surface, strip, rows);
}

SpanGroups::Added SpanGroups::add(SurfaceId mesh, std::uint32_t face, int strip,
                                  const LaneRowRanges& rows) {
  return add(kFace | face, mesh, strip, rows);
}

SpanGroups::Added SpanGroups::add(std::uint32_t owner, SurfaceId surface, int strip,
                                  const LaneRowRanges& rows) {
  const LaneSet lanes = rows.lanes();
  if (lanes == 0) return {nullptr, 0};
  const Rows all = allRows(rows);
  const std::uint32_t index = indexFor(owner, strip, lanes, all.begin, all.end);
  SpanGroup& group = groups_[index];
  const bool isNew = group.lanes == 0;
  group.surface = surface;
  group.lanes |= lanes;
  links_[index].lanes = group.lanes;
  group.rowBegin = std::min(group.rowBegin, all.begin);
  group.rowEnd = std::max(group.rowEnd, all.end);
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) {
    group.rows.begin[lane] = rows.has(lane) ? rows.begin[lane] : group.rows.begin[lane];
    group.rows.end[lane] = rows.has(lane) ? rows.end[lane] : group.rows.end[lane];
  }
  strips_[indexOf(strip)].pixels += static_cast<std::size_t>(rows.rowCount());
  spans_ += static_cast<std::size_t>(rows.laneCount());
  return {&group, isNew ? kAllLanes : lanes};
}

void SpanGroups::addFaces(SurfaceId mesh, int strip, std::span<const FaceSpan> faces) {
  const std::uint32_t index = begin(mesh.value, strip);
  // As if it had spans in all columns. Then no later span joins it, or a group before it.
  links_[index].lanes = kAllLanes;
  if (facesCount_ == faces_.size()) faces_.emplace_back();
  std::vector<FaceSpan>& kept = faces_[facesCount_++];
  kept.assign(faces.begin(), faces.end());
  SpanGroup& group = groups_[index];
  group.surface = mesh;
  group.lanes = kAllLanes;
  group.faces = kept;
  for (const FaceSpan& span : faces) {
    group.rowBegin = std::min(group.rowBegin, span.rowBegin);
    group.rowEnd = std::max(group.rowEnd, span.rowEnd);
    strips_[indexOf(strip)].pixels += static_cast<std::size_t>(span.rowEnd - span.rowBegin);
  }
  spans_ += faces.size();
}

/// A group of the owner that has no spans in these lanes yet, or a new one. With LastToFirst a
/// span must not join a group that was added before another span of its column: it would be painted
/// over that.
std::uint32_t SpanGroups::indexFor(std::uint32_t owner, int strip, LaneSet lanes, int rowBegin,
                                   int rowEnd) {
  std::uint32_t index = strips_[indexOf(strip)].last;
  for (int i = 0; i < kLookedAt && index != kNone; ++i, index = links_[index].before) {
    const Link& link = links_[index];
    if ((link.lanes & lanes) != 0) {
      if (order_ == Order::LastToFirst) break;
    } else if (link.owner == owner && rowBegin < groups_[index].rowEnd &&
               groups_[index].rowBegin < rowEnd) {
      return index;
    }
  }
  return begin(owner, strip);
}

std::uint32_t SpanGroups::begin(std::uint32_t owner, int strip) {
  const auto index = static_cast<std::uint32_t>(links_.size());
  std::uint32_t& last = strips_[indexOf(strip)].last;
  links_.push_back({last, owner, 0});
  last = index;
  if (index == groups_.size()) groups_.emplace_back();
  SpanGroup& group = groups_[index];
  group.view = nullptr;
  group.face = nullptr;
  group.faces = {};
  group.firstColumn = strip * Strip::kColumns;
  group.lanes = 0;
  group.rowBegin = std::numeric_limits<int>::max();
  group.rowEnd = 0;
  group.rows = {};
  return index;
}

}  // namespace hearth
