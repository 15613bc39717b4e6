#include "render/mesh_spans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "math/tolerance.h"

namespace hearth {

/// Between which nearnesses (1 / depth) the ray of a column is in the air of its sector.
struct MeshSpans::Air {
  double slant;
  double least;  ///< where it leaves the sector
  double most;   ///< where it enters it
  // How far the floor and the ceiling are from the eye, above or below its place on the map, and
  // how they rise along the ray per metre of depth.
  double floorBelow;
  double floorRise;
  double ceilingAbove;
  double ceilingRise;

  bool contains(double nearness, double raySlope) const {
    return nearness >= least && nearness <= most && floorBelow * nearness + raySlope >= floorRise &&
           ceilingAbove * nearness + ceilingRise >= raySlope;
  }
};

namespace {

/// The slope of a plane along a ray on the map.
double riseAlong(const std::optional<Slope>& slope, Vec2 ray) {
  return slope ? dot(slope->gradient, ray) : 0;
}

/// Those of a column's rows that a face covers.
CoveredRows rowsOf(const FaceFront& front, double slant, const Projection& projection,
                   CoveredRows rows) {
  for (const Vec3 edge : front.edges) {
    const double level = edge.x + slant * edge.y;
    if (edge.z == 0) {
      // Upright: what is exactly on a left edge is inside.
      if (level < 0 || (level == 0 && edge.y <= 0)) return {0, 0};
      continue;
    }
    const int row = projection.rowIn(rows.begin, rows.end, -level / edge.z);
    (edge.z > 0 ? rows.end : rows.begin) = row;
    if (rows.begin >= rows.end) return {0, 0};
  }
  return rows;
}

}  // namespace

MeshSpans::MeshSpans(const Scene& scene, const Camera& camera, const Projection& projection,
                     ColumnRange columns, MeshSpansScratch& scratch)
    : scene_(scene), projection_(projection), scratch_(scratch) {
  if (scene.level().meshes.empty()) return;
  scratch_.fronts.begin(scene.level(), columns);
  scratch_.nearest.resize(static_cast<std::size_t>(camera.height) * Strip::kColumns);
}

bool MeshSpans::find(const ColumnRun& run, const RunEntry& entry) {
  begin_ = end_ = 0;
  const std::span<const MeshInSector> meshes = scene_.level().meshesIn(run.sector.id);
  for (const MeshInSector& there : meshes) scratch_.fronts.find(scene_, projection_, there.mesh);
  std::array<Air, Strip::kColumns> air;
  bool hasAir = false;
  for (const MeshInSector& there : meshes) {
    const auto inStrip = scratch_.fronts.inStrip(there.mesh, run.strip);
    if (inStrip.empty()) continue;
    if (!std::exchange(hasAir, true))
      for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane)
        air[lane] = airOf(run, entry, lane);
    const std::span<const FaceFront> fronts = scratch_.fronts.frontsOf(there.mesh);
    for (const std::uint32_t i : inStrip) cover(run, fronts[i], air);
  }
  return begin_ < end_;
}

MeshSpans::Air MeshSpans::airOf(const ColumnRun& run, const RunEntry& entry,
                                std::size_t lane) const {
  const Vec3 eye = projection_.eye();
  const double column = run.strip * Strip::kColumns + static_cast<double>(lane) + 0.5;
  const Vec2 ray = projection_.rayOf(column);
  const double enters = entry.depths[lane] * (1 - kNearTie) - kPositionSlack;
  return {projection_.slantOf(column),
          1 / (run.depths[lane] * (1 + kNearTie) + kPositionSlack),
          enters > 0 ? 1 / enters : std::numeric_limits<double>::infinity(),
          eye.z - scene_.airBottom(run.sector, eye.xy()) + kPositionSlack,
          riseAlong(run.sector.floorSlope, ray),
          scene_.airTop(run.sector, eye.xy()) - eye.z + kPositionSlack,
          riseAlong(run.sector.ceilingSlope, ray)};
}

/// Puts a face into the pixels of a run in which it is the nearest.
void MeshSpans::cover(const ColumnRun& run, const FaceFront& front, std::span<const Air> air) {
  const int firstColumn = run.strip * Strip::kColumns;
  const auto laneOf = [&](int column) {
    return static_cast<std::size_t>(std::clamp(column - firstColumn, 0, Strip::kColumns));
  };
  const std::size_t end = std::min(run.laneEnd, laneOf(front.columns.end));
  for (std::size_t lane = std::max(run.laneBegin, laneOf(front.columns.begin)); lane < end; ++lane)
    if (run.open.has(lane))
      cover(
          front, air[lane], lane,
          rowsOf(front, air[lane].slant, projection_, {run.open.begin[lane], run.open.end[lane]}));
}

/// Meshes come in the order of things: of two at one depth the later stays.
void MeshSpans::cover(const FaceFront& front, const Air& air, std::size_t lane, CoveredRows rows) {
  if (rows.begin >= rows.end) return;
  reach(rows.begin, rows.end);
  for (int row = rows.begin; row < rows.end; ++row) {
    const double raySlope = projection_.raySlopeAt(row + 0.5);
    const double nearness = front.nearnessAt(air.slant, raySlope);
    Nearest& nearest = at(lane, row);
    if (nearness >= nearest.nearness * (1 - kNearTie) && air.contains(nearness, raySlope))
      nearest = {nearness, &front};
  }
}

/// Empties rows that no face has reached before.
void MeshSpans::reach(int begin, int end) {
  const auto clear = [&](int first, int last) {
    if (first >= last) return;
    std::fill(&at(0, first), &at(0, last - 1) + Strip::kColumns, Nearest{});
  };
  if (begin_ >= end_) {
    clear(begin, end);
    begin_ = begin;
    end_ = end;
    return;
  }
  clear(begin, begin_);
  clear(end_, end);
  begin_ = std::min(begin_, begin);
  end_ = std::max(end_, end);
}

bool MeshSpans::hide(std::size_t lane, int row, double depth, std::uint32_t thing) const {
  if (row < begin_ || row >= end_) return false;
  const Nearest& nearest = at(lane, row);
  if (!nearest.front) return false;
  const double times = depth * nearest.nearness;
  if (std::abs(times - 1) <= kNearTie) return nearest.front->thing > thing;
  return times > 1;
}

void MeshSpans::show(const ColumnRun& run, SpanGroups& found) {
  scratch_.narrow.clear();
  for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane) {
    int row = std::max(begin_, run.open.begin[lane]);
    const int last = std::min(end_, run.open.end[lane]);
    while (row < last) {
      const int begin = row;
      const FaceFront* const front = at(lane, begin).front;
      while (row < last && at(lane, row).front == front) ++row;
      if (!front) continue;
      const double least = std::min(at(lane, begin).nearness, at(lane, row - 1).nearness);
      show(run, {front, lane, begin, row, 1 / least}, found);
    }
  }
  showNarrow(run, found);
}

/// Those of narrow faces are put off, to be added all at once.
void MeshSpans::show(const ColumnRun& run, const FaceSpan& span, SpanGroups& found) {
  if (span.front->isNarrow) {
    scratch_.narrow.push_back(span);
    return;
  }
  LaneRowRanges rows;
  rows.begin[span.lane] = span.rowBegin;
  rows.end[span.lane] = span.rowEnd;
  const auto [group, lanes] = found.add(span.front->mesh, span.front->index, run.strip, rows);
  group->face = span.front->face;
  LaneDoubles depth;
  depth.fill(span.depth);
  setLanes(group->depth, depth, lanes);
}

void MeshSpans::showNarrow(const ColumnRun& run, SpanGroups& found) {
  std::vector<FaceSpan>& all = scratch_.narrow;
  const auto place = [](const FaceSpan& span) {
    return std::tuple(span.front->mesh, span.lane, span.rowBegin);
  };
  // Those of a single mesh are.
  if (!std::ranges::is_sorted(all, {}, place)) std::ranges::sort(all, {}, place);
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].front->mesh == all[begin].front->mesh) ++end;
    found.addFaces(all[begin].front->mesh, run.strip, std::span(all).subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace hearth
