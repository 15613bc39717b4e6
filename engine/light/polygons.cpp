#include "light/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/predicates.h"

namespace hearth {

namespace {

/// A cheap bound: to the upright box round an edge, by the longer of its two coordinates.
double distanceToBox(const Polygons::Edge& edge, Vec2 p) {
  const auto& [a, b] = edge;
  const double x = std::max(std::min(a.x, b.x) - p.x, p.x - std::max(a.x, b.x));
  const double y = std::max(std::min(a.y, b.y) - p.y, p.y - std::max(a.y, b.y));
  return std::max(x, y);
}

}  // namespace

Polygons::Polygons(const std::vector<std::vector<Vec2>>& polygons) {
  for (const std::vector<Vec2>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      edges_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
    ends_.push_back(edges_.size());
  }
}

std::vector<std::vector<Vec2>> Polygons::loops() const {
  std::vector<std::vector<Vec2>> polygons;
  std::size_t i = 0;
  for (const std::size_t end : ends_)
    for (std::vector<Vec2>& polygon = polygons.emplace_back(); i < end; ++i)
      polygon.push_back(edges_[i].a);
  return polygons;
}

bool Polygons::contains(Vec2 p) const {
  bool inside = false;
  for (const auto& [a, b] : edges_) {
    if (a == p) return true;
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const int side = orientation(a, b, p);
    if (side == 0) return true;
    if ((side > 0) == (b.y <= p.y)) inside = !inside;
  }
  return inside;
}

Vec2 Polygons::nearest(Vec2 p) const {
  Vec2 best = edges_.front().a;
  double distance = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) {
    if (distanceToBox(edge, p) > distance) continue;
    const Vec2 q = nearestOnSegment(edge.a, edge.b, p);
    const double found = length(q - p);
    if (found < distance) best = q, distance = found;
  }
  return best;
}

std::vector<Polygons::Edge> Polygons::edgesWithin(Vec2 p, double reach) const {
  std::vector<Edge> edges;
  for (const Edge& edge : edges_)
    if (distanceToBox(edge, p) <= reach && length(nearestOnSegment(edge.a, edge.b, p) - p) <= reach)
      edges.push_back(edge);
  return edges;
}

Polygons Polygons::aroundRow(double row, double reach) const {
  Polygons around;
  around.edges_.reserve(edges_.size());
  for (const Edge& edge : edges_)
    if (std::min(edge.a.y, edge.b.y) - row <= reach && row - std::max(edge.a.y, edge.b.y) <= reach)
      around.edges_.push_back(edge);
  return around;
}

/// The parts of the row with an edge no farther than `margin` along both axes: in rising order, and
/// apart. Between two of these all is inside, or all is outside.
std::vector<Polygons::Stretch> Polygons::besideEdges(double row, double margin) const {
  std::vector<Stretch> beside;
  beside.reserve(edges_.size());
  for (const Edge& edge : edges_) {
    const Vec2 a = edge.a;
    const Vec2 b = edge.b;
    const double low = std::max(std::min(a.y, b.y), row - margin);
    const double high = std::min(std::max(a.y, b.y), row + margin);
    if (low > high) continue;
    const auto xAt = [&a, &b](double y) { return std::lerp(a.x, b.x, (y - a.y) / (b.y - a.y)); };
    const bool isLevel = a.y == b.y;
    const double ends[] = {isLevel ? a.x : xAt(low), isLevel ? b.x : xAt(high)};
    beside.push_back({std::min(ends[0], ends[1]) - margin, std::max(ends[0], ends[1]) + margin});
  }
  std::ranges::sort(beside, {}, &Stretch::from);
  std::size_t apart = 0;
  for (const Stretch& next : beside) {
    if (apart == 0 || beside[apart - 1].to < next.from)
      beside[apart++] = next;
    else
      beside[apart - 1].to = std::max(beside[apart - 1].to, next.to);
  }
  beside.resize(apart);
  return beside;
}

bool Polygons::isInsideBetween(double row, const Stretch& before, const Stretch& after) const {
  return contains({(before.to + after.from) / 2, row});
}

std::vector<Polygons::Stretch> Polygons::insideAlong(double row, double margin) const {
  const std::vector<Stretch> beside = besideEdges(row, margin);
  std::vector<Stretch> inside;
  for (std::size_t i = 0; i + 1 < beside.size(); ++i)
    if (isInsideBetween(row, beside[i], beside[i + 1]))
      inside.push_back({beside[i].to, beside[i + 1].from});
  return inside;
}

std::vector<Polygons::Stretch> Polygons::nearAlong(double row, double margin) const {
  std::vector<Stretch> near;
  for (const Stretch& next : besideEdges(row, margin)) {
    if (!near.empty() && isInsideBetween(row, near.back(), next))
      near.back().to = next.to;
    else
      near.push_back(next);
  }
  return near;
}

}  // namespace hearth
