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
  groupCount_ = 0;
  faceGroupCount_ = 0;
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
  Link& link = linkFor(owner, strip, lanes, all.begin, all.end);
  SpanGroup& group = groups_[link.index];
  const bool isNew = group.lanes == 0;
  group.surface = surface;
  group.lanes |= lanes;
  link.lanes = group.lanes;
  if (isNew) {
    group.rowBegin = all.begin;
    group.rowEnd = all.end;
    group.rows = rows;
  } else {
    group.rowBegin = std::min(group.rowBegin, all.begin);
    group.rowEnd = std::max(group.rowEnd, all.end);
    for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) {
      group.rows.begin[lane] = rows.has(lane) ? rows.begin[lane] : group.rows.begin[lane];
      group.rows.end[lane] = rows.has(lane) ? rows.end[lane] : group.rows.end[lane];
    }
  }
  strips_[indexOf(strip)].pixels += static_cast<std::size_t>(rows.rowCount());
  spans_ += static_cast<std::size_t>(rows.laneCount());
  return {&group, isNew ? kAllLanes : lanes};
}

void SpanGroups::addFaces(SurfaceId mesh, int strip, std::span<const FaceSpan> faces) {
  // As if it had spans in all columns. So `linkFor` never takes it, nor a group before it.
  append(strip, {kNone, mesh.value, faceGroupCount_, kAllLanes, true});
  if (faceGroupCount_ == faceGroups_.size()) faceGroups_.emplace_back();
  FaceGroup& group = faceGroups_[faceGroupCount_++];
  group.mesh = mesh;
  group.firstColumn = strip * Strip::kColumns;
  group.rowBegin = std::numeric_limits<int>::max();
  group.rowEnd = 0;
  group.pixels = 0;
  group.spans.assign(faces.begin(), faces.end());
  for (const FaceSpan& span : faces) {
    group.rowBegin = std::min(group.rowBegin, span.rowBegin);
    group.rowEnd = std::max(group.rowEnd, span.rowEnd);
    group.pixels += static_cast<std::size_t>(span.rowEnd - span.rowBegin);
  }
  strips_[indexOf(strip)].pixels += group.pixels;
  spans_ += faces.size();
}

/// A group of the owner that has no spans in these lanes yet, or a new one. With LastToFirst a
/// span must not join a group that was added before another span of its column: it would be painted
/// over that.
SpanGroups::Link& SpanGroups::linkFor(std::uint32_t owner, int strip, LaneSet lanes, int rowBegin,
                                      int rowEnd) {
  std::uint32_t index = strips_[indexOf(strip)].last;
  for (int i = 0; i < kLookedAt && index != kNone; ++i, index = links_[index].before) {
    Link& link = links_[index];
    if ((link.lanes & lanes) != 0) {
      if (order_ == Order::LastToFirst) break;
    } else if (link.owner == owner && rowBegin < groups_[link.index].rowEnd &&
               groups_[link.index].rowBegin < rowEnd) {
      return link;
    }
  }
  return begin(owner, strip);
}

SpanGroups::Link& SpanGroups::begin(std::uint32_t owner, int strip) {
  Link& link = append(strip, {kNone, owner, groupCount_, 0, false});
  if (groupCount_ == groups_.size()) groups_.emplace_back();
  SpanGroup& group = groups_[groupCount_++];
  group.view = nullptr;
  group.face = nullptr;
  group.zTop = 0;
  group.firstColumn = strip * Strip::kColumns;
  group.lanes = 0;
  return link;
}

SpanGroups::Link& SpanGroups::append(int strip, Link link) {
  std::uint32_t& last = strips_[indexOf(strip)].last;
  link.before = last;
  last = static_cast<std::uint32_t>(links_.size());
  links_.push_back(link);
  return links_.back();
}

}  // namespace hearth
