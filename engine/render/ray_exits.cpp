#include "render/ray_exits.h"

#include <algorithm>
#include <numeric>

#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Number by number: see Window on store-forwarding stalls.
void set(ColumnHit& to, const ColumnHit& hit) {
  to.segment = hit.segment;
  to.hasLevelAir = hit.hasLevelAir;
  to.depth = hit.depth;
  to.fraction = hit.fraction;
}

/// The index of the first window whose column is not left of this one. Most often there is a window
/// in every column.
std::size_t firstNotLeftOf(const std::vector<Window>& windows, int column) {
  const auto size = static_cast<std::ptrdiff_t>(windows.size());
  const auto guess = std::clamp<std::ptrdiff_t>(column - windows.front().column, 0, size);
  const auto isLeft = [column](const Window& window) { return window.column < column; };
  if ((guess == 0 || isLeft(windows[static_cast<std::size_t>(guess - 1)])) &&
      (guess == size || !isLeft(windows[static_cast<std::size_t>(guess)])))
    return static_cast<std::size_t>(guess);
  return static_cast<std::size_t>(std::ranges::partition_point(windows, isLeft) - windows.begin());
}

}  // namespace

RayExits::RayExits(const Scene& scene, const Projection& projection, int width, ColumnRange columns,
                   RayExitScratch& scratch)
    : scene_(scene), projection_(projection), width_(width), columns_(columns), scratch_(scratch) {
  scratch_.fronts.clear();
  scratch_.cellFronts.clear();
  scratch_.slants.clear();
  for (int column = columns_.begin; column < columns_.end; ++column)
    scratch_.slants.push_back(projection_.slantOf(column + 0.5));
}

const std::vector<ColumnHit>& RayExits::closest(SectorId sector, std::optional<SegmentId> entry,
                                                const std::vector<Window>& windows) {
  std::vector<ColumnHit>& closest = scratch_.closest;
  closest.assign(windows.size(), {SegmentId(0), false, kNoDepth, 0});
  const auto keepNearer = [&](std::size_t k, const ColumnHit& hit) {
    if (isBeyond(entry, windows[k].depth, hit) && isNearer(hit, closest[k])) set(closest[k], hit);
  };
  if (const WallGrid* const grid = scene_.level().wallGridOf(scene_[sector]))
    for (std::size_t k = 0; k < windows.size(); ++k)
      walkCells(
          sector, *grid, windows[k].column, windows[k].depth * (1 - 2 * kNearTie),
          [&](const ColumnHit& hit) {
            if (hit.segment != entry) keepNearer(k, hit);
          },
          [&] { return closest[k].depth; });
  else
    meetSegments(sector, entry, windows, keepNearer);
  return closest;
}

/// Calls `met(k, hit)` for each window k and each segment but `except` whose front shows in the
/// window's column.
template <typename Met>
void RayExits::meetSegments(SectorId sector, std::optional<SegmentId> except,
                            const std::vector<Window>& windows, Met&& met) {
  for (const SegmentFront& front : frontsOf(sector)) {
    if (front.segment == except || front.columns.end <= windows.front().column ||
        front.columns.begin > windows.back().column)
      continue;
    const std::size_t end = firstNotLeftOf(windows, front.columns.end);
    for (std::size_t k = firstNotLeftOf(windows, front.columns.begin); k < end; ++k) {
      const auto [depth, fraction] = front.meetings.at(slantOf(windows[k].column));
      met(k, ColumnHit{front.segment, front.hasLevelAir, depth, fraction});
    }
  }
}

std::span<const SegmentFront> RayExits::frontsOf(SectorId sector) {
  ById<SectorId, SegmentFront>& fronts = scratch_.fronts;
  if (!fronts.has(sector)) {
    fronts.begin(sector);
    for (const Segment& segment : scene_.segmentsOf(scene_[sector])) addFront(segment, fronts);
  }
  return fronts.of(sector);
}

std::span<const SegmentFront> RayExits::frontsIn(SectorId sector, const WallGrid& grid,
                                                 CellId cell) {
  ById<CellId, SegmentFront>& fronts = scratch_.cellFronts;
  if (!fronts.has(cell)) {
    fronts.begin(cell);
    const std::span<const Segment> segments = scene_.segmentsOf(scene_[sector]);
    for (const std::uint32_t i : grid.wallsIn(cell)) addFront(segments[i], fronts);
  }
  return fronts.of(cell);
}

/// Adds the segment if it covers columns of the frame.
template <typename Fronts>
void RayExits::addFront(const Segment& segment, Fronts& fronts) {
  ++projectedSegments_;
  if (const auto front = frontOf(scene_, projection_, segment, width_, columns_))
    fronts.add(*front);
}

/// Calls `met(hit)` for the segments that the ray through a column meets beyond a depth, up to
/// where `end()` says. It may meet some more, and one more than once.
template <typename Met, typename End>
void RayExits::walkCells(SectorId sector, const WallGrid& grid, int column, double from, Met&& met,
                         End&& end) {
  const double slant = slantOf(column);
  grid.alongRay(projection_.eye().xy(), projection_.rayOf(column + 0.5), from, [&](CellId cell) {
    for (const SegmentFront& front : frontsIn(sector, grid, cell)) {
      if (column < front.columns.begin || column >= front.columns.end) continue;
      const auto [depth, fraction] = front.meetings.at(slant);
      met(ColumnHit{front.segment, front.hasLevelAir, depth, fraction});
    }
    return end();
  });
}

double RayExits::slantOf(int column) const {
  return scratch_.slants[static_cast<std::size_t>(column - columns_.begin)];
}

bool RayExits::isBeyond(std::optional<SegmentId> entry, double entryDepth,
                        const ColumnHit& hit) const {
  if (hit.depth > entryDepth * (1 + kNearTie)) return true;
  if (!entry || hit.depth < entryDepth * (1 - kNearTie)) return false;
  return inOrder(*entry, hit.segment);
}

bool RayExits::isNearer(const ColumnHit& a, const ColumnHit& b) const {
  if (a.depth < b.depth * (1 - kNearTie)) return true;
  if (a.depth > b.depth * (1 + kNearTie)) return false;
  return inOrder(a.segment, b.segment);
}

bool RayExits::inOrder(SegmentId a, SegmentId b) const {
  return meetsFirst(projection_.eye().xy(), scene_[a].p0, scene_[a].p1, scene_[b].p0, scene_[b].p1);
}

void RayExits::findStretches(const std::vector<SectorId>& members,
                             const std::vector<Window>& windows) {
  scratch_.stretches.clear();
  for (const SectorId member : members) {
    const auto add = [&](std::size_t k, const ColumnHit& exit) {
      scratch_.stretches.push_back({k, {member, exit}});
    };
    if (const WallGrid* const grid = scene_.level().wallGridOf(scene_[member]))
      for (std::size_t k = 0; k < windows.size(); ++k)
        for (const ColumnHit& exit : crossings(member, *grid, windows[k].column)) add(k, exit);
    else
      meetSegments(member, std::nullopt, windows, add);
  }
  groupByWindow(windows.size());
  for (std::size_t i = 0; i < windows.size(); ++i) sortByDepth(stretchesIn(i));
}

/// All segments that the ray through a column meets, each once, in the sector's order.
const std::vector<ColumnHit>& RayExits::crossings(SectorId sector, const WallGrid& grid,
                                                  int column) {
  std::vector<ColumnHit>& crossed = scratch_.crossed;
  crossed.clear();
  walkCells(
      sector, grid, column, 0, [&](const ColumnHit& hit) { crossed.push_back(hit); },
      [] { return kNoDepth; });
  std::ranges::sort(crossed, {}, &ColumnHit::segment);
  const auto isSame = [](const ColumnHit& a, const ColumnHit& b) { return a.segment == b.segment; };
  crossed.erase(std::unique(crossed.begin(), crossed.end(), isSame), crossed.end());
  return crossed;
}

std::span<Stretch> RayExits::stretchesIn(std::size_t window) {
  const std::size_t begin = scratch_.stretchesBegin[window];
  return std::span(scratch_.stretchesByWindow)
      .subspan(begin, scratch_.stretchesBegin[window + 1] - begin);
}

/// Counts the stretches of each window, and puts them where those of the windows before end.
void RayExits::groupByWindow(std::size_t windowCount) {
  std::vector<std::size_t>& begin = scratch_.stretchesBegin;
  begin.assign(windowCount + 2, 0);
  for (const auto& [window, stretch] : scratch_.stretches) ++begin[window + 2];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  scratch_.stretchesByWindow.resize(scratch_.stretches.size());
  for (const auto& [window, stretch] : scratch_.stretches)
    scratch_.stretchesByWindow[begin[window + 1]++] = stretch;
}

/// Near to far, near ties in exact order.
void RayExits::sortByDepth(std::span<Stretch> stretches) const {
  std::ranges::sort(stretches, {}, [](const Stretch& stretch) { return stretch.exit.depth; });
  for (std::size_t i = 1; i < stretches.size(); ++i)
    for (std::size_t k = i; k > 0 && isNearer(stretches[k].exit, stretches[k - 1].exit); --k)
      std::swap(stretches[k], stretches[k - 1]);
}

}  // namespace hearth
