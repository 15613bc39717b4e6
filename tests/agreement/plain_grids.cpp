#include "agreement/plain_grids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "agreement/common_edges.h"
#include "math/tolerance.h"

namespace hearth::agreement {

namespace {

using Panels = std::vector<std::optional<Panel>>;

/// Gathers runs: of all that continue one another, the plane of the first being that of all.
/// `isInPlane(first, next, beside)` says whether a panel is, that goes on from `beside`.
template <typename IsInPlane>
std::vector<std::vector<std::size_t>> runsOf(const Scene& scene, const std::vector<Vec3>& corners,
                                             const Panels& panels,
                                             const std::vector<std::size_t>& order,
                                             IsInPlane&& isInPlane) {
  std::vector<bool> isTaken(panels.size());
  std::vector<std::vector<std::size_t>> runs;
  for (const std::size_t first : order) {
    if (isTaken[first]) continue;
    isTaken[first] = true;
    std::vector<std::size_t>& run = runs.emplace_back(1, first);
    for (std::size_t i = 0; i < run.size(); ++i)
      for (const std::size_t next : order) {
        if (isTaken[next] || !isInPlane(first, next, run[i])) continue;
        if (commonEdges(scene, corners, *panels[run[i]], *panels[next]).empty() &&
            commonEdges(scene, corners, *panels[next], *panels[run[i]]).empty())
          continue;
        isTaken[next] = true;
        run.push_back(next);
      }
  }
  return runs;
}

/// From the first vertex of the run's walls, along the longest of them, and z. All are in the plane
/// of the longest, to within a thousandth of the shorter of two that meet, and a millimetre.
std::vector<Axes> wallGrids(const Scene& scene, const std::vector<Vec3>& corners) {
  Panels walls;
  for (const Segment& wall : scene.level().segments) walls.push_back(panelOf(scene, wall));
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (!walls[i]->edges.empty()) order.push_back(i);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const Segment& wallA = scene.level().segments[a];
    const Segment& wallB = scene.level().segments[b];
    if (wallA.length != wallB.length) return wallA.length > wallB.length;
    return lessXY(wallA.p0, wallB.p0);
  });
  const auto isInPlane = [&](std::size_t longest, std::size_t next, std::size_t beside) {
    const Segment& wall = scene.level().segments[next];
    const double noise = noiseOf(std::min(wall.length, scene.level().segments[beside].length));
    return dot(walls[longest]->normal, walls[next]->normal) > 0 &&
           std::ranges::all_of(std::array{wall.p0, wall.p1}, [&](Vec2 p) {
             return std::abs(walls[longest]->distanceInFront({p.x, p.y, 0})) <= noise;
           });
  };
  std::vector<Axes> grids;
  for (const auto& wall : walls) grids.push_back(wall->axes);
  for (const std::vector<std::size_t>& run : runsOf(scene, corners, walls, order, isInPlane)) {
    Vec2 first = scene.level().segments[run.front()].p0;
    for (const std::size_t i : run)
      for (const Vec2 vertex : {scene.level().segments[i].p0, scene.level().segments[i].p1})
        if (lessXY(vertex, first)) first = vertex;
    for (const std::size_t i : run)
      grids[i] = {{first.x, first.y, 0}, walls[run.front()]->axes.s, {0, 0, 1}};
  }
  return grids;
}

Vec2 firstBorderVertex(const Scene& scene, const Sector& sector) {
  const Loop& border = sector.loops.front();
  Vec2 first = scene[border.first].p0;
  for (std::size_t i = 0; i < border.count; ++i) {
    const Vec2 vertex = scene.level().segments[border.first.index() + i].p0;
    if (lessXY(vertex, first)) first = vertex;
  }
  return first;
}

/// Of slopes: from the first border vertex of the run, along the contour line and the steepest
/// ascent of the slope that has it. What is not sloped keeps the axes of its panel.
std::vector<Axes> slopeGrids(const Scene& scene, const std::vector<Vec3>& corners,
                             const Panels& panels) {
  const auto sectorOf = [&](std::size_t i) -> const Sector& {
    return scene[scene.level().surfaces[i].sector];
  };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < panels.size(); ++i)
    if (panels[i] && isSlope(scene.level().surfaces[i].kind)) order.push_back(i);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return lessXY(firstBorderVertex(scene, sectorOf(a)), firstBorderVertex(scene, sectorOf(b)));
  });
  const auto isInPlane = [&](std::size_t, std::size_t next, std::size_t beside) {
    return areInOnePlane(*panels[beside], *panels[next]);
  };
  std::vector<Axes> grids;
  for (const auto& panel : panels) grids.push_back(panel ? panel->axes : Axes{});
  for (const std::vector<std::size_t>& run : runsOf(scene, corners, panels, order, isInPlane)) {
    const Sector& sector = sectorOf(run.front());
    const Vec2 first = firstBorderVertex(scene, sector);
    const bool isOver = facesDown(scene.level().surfaces[run.front()].kind);
    Axes axes = panels[run.front()]->axes;
    axes.origin = {first.x, first.y,
                   isOver ? scene.airTop(sector, first) : scene.airBottom(sector, first)};
    for (const std::size_t i : run) grids[i] = axes;
  }
  return grids;
}

}  // namespace

std::vector<Axes> plainGrids(const Scene& scene, const std::vector<std::optional<Panel>>& panels) {
  const std::vector<Vec3> corners = cornersOf(scene, panels);
  const std::vector<Axes> ofWalls = wallGrids(scene, corners);
  std::vector<Axes> grids = slopeGrids(scene, corners, panels);
  for (std::size_t i = 0; i < panels.size(); ++i)
    if (const std::optional<SegmentId> segment = scene.level().surfaces[i].segment)
      grids[i] = ofWalls[segment->index()];
  return grids;
}

}  // namespace hearth::agreement
