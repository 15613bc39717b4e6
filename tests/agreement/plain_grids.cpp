#include "agreement/plain_grids.h"

#include <algorithm>
#include <numeric>

#include "agreement/common_edges.h"

namespace hearth::agreement {

namespace {

/// By index of panel, the least index of its run: of all that continue one another. Without a
/// panel, or where `isMember` says no, a run of its own.
template <typename IsMember>
std::vector<std::size_t> runsOf(const Level& level, const std::vector<Vec3>& corners,
                                const std::vector<std::optional<Panel>>& panels,
                                IsMember&& isMember) {
  std::vector<std::size_t> run(panels.size());
  std::iota(run.begin(), run.end(), std::size_t{0});
  for (std::size_t a = 0; a < panels.size(); ++a)
    for (std::size_t b = 0; b < panels.size(); ++b) {
      if (run[a] == run[b] || !isMember(a) || !isMember(b)) continue;
      if (commonEdges(level, corners, *panels[a], *panels[b]).empty()) continue;
      const auto [joined, former] = std::minmax(run[a], run[b]);
      std::ranges::replace(run, std::size_t{former}, std::size_t{joined});
    }
  return run;
}

/// From the first vertex of the run's walls, along the longest of them, and z.
std::vector<Axes> wallGrids(const Level& level, const std::vector<Vec3>& corners) {
  std::vector<std::optional<Panel>> walls;
  for (const Segment& wall : level.segments) walls.push_back(panelOf(level, wall));
  const auto runs =
      runsOf(level, corners, walls, [&](std::size_t i) { return !walls[i]->edges.empty(); });
  std::vector<Axes> grids;
  for (const std::size_t run : runs) {
    const Segment* longest = &level.segments[run];
    Vec2 first = longest->p0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs[i] != run) continue;
      const Segment& wall = level.segments[i];
      if (wall.length > longest->length) longest = &wall;
      for (const Vec2 vertex : {wall.p0, wall.p1})
        if (lessXY(vertex, first)) first = vertex;
    }
    const Vec2 along = (1 / longest->length) * (longest->p1 - longest->p0);
    grids.push_back({{first.x, first.y, 0}, {along.x, along.y, 0}, {0, 0, 1}});
  }
  return grids;
}

Vec2 firstBorderVertex(const Level& level, const Sector& sector) {
  const Loop& border = sector.loops.front();
  Vec2 first = level[border.first].p0;
  for (std::size_t i = 0; i < border.count; ++i) {
    const Vec2 vertex = level.segments[border.first.index() + i].p0;
    if (lessXY(vertex, first)) first = vertex;
  }
  return first;
}

}  // namespace

std::vector<Axes> plainGrids(const Level& level, const std::vector<std::optional<Panel>>& panels) {
  const std::vector<Vec3> corners = cornersOf(level, panels);
  const std::vector<Axes> ofWalls = wallGrids(level, corners);
  const auto slopeRuns = runsOf(level, corners, panels,
                                [&](std::size_t i) { return isSlope(level.surfaces[i].kind); });
  std::vector<Axes> grids(panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (!panels[i]) continue;
    const Surface& surface = level.surfaces[i];
    grids[i] = surface.segment ? ofWalls[surface.segment->index()] : panels[i]->axes;
    if (!isSlope(surface.kind)) continue;
    const Sector& sector = level[surface.sector];
    Vec2 first = firstBorderVertex(level, sector);
    for (std::size_t k = 0; k < panels.size(); ++k) {
      if (slopeRuns[k] != slopeRuns[i]) continue;
      const Vec2 vertex = firstBorderVertex(level, level[level.surfaces[k].sector]);
      if (lessXY(vertex, first)) first = vertex;
    }
    const Slope& slope = isOverhead(surface.kind) ? *sector.ceilingSlope : *sector.floorSlope;
    grids[i].origin = {first.x, first.y, slope.zAt(first)};
  }
  return grids;
}

}  // namespace hearth::agreement
