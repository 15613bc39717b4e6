#include "light/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/predicates.h"

namespace hearth {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/// From so many edges on, a tree finds some of them sooner than a look at all.
constexpr std::size_t kManyEdges = 64;

/// Texels, by which more is looked at, so that rounding leaves out no edge.
constexpr double kRounding = 1;

/// A cheap bound: to the upright box round an edge, by the longer of its two coordinates.
double distanceToBox(const Polygons::Edge& edge, Vec2 p) {
  const auto& [a, b] = edge;
  const double x = std::max(std::min(a.x, b.x) - p.x, p.x - std::max(a.x, b.x));
  const double y = std::max(std::min(a.y, b.y) - p.y, p.y - std::max(a.y, b.y));
  return std::max(x, y);
}

}  // namespace

bool Polygons::Edge::isWithin(double reach, Vec2 p) const {
  return distanceToBox(*this, p) <= reach && length(nearestOnSegment(a, b, p) - p) <= reach;
}

Polygons::Polygons(std::span<const std::vector<Vec2>> polygons) {
  std::size_t edges = 0;
  for (const std::vector<Vec2>& polygon : polygons) edges += polygon.size();
  edges_.reserve(edges);
  for (const std::vector<Vec2>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      edges_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
    if (&polygon != &polygons.back()) endsOfOthers_.push_back(edges_.size());
  }
  if (edges_.size() < kManyEdges) return;
  std::vector<Box> boxes;
  boxes.reserve(edges_.size());
  for (const Edge& edge : edges_) boxes.push_back(boxOf(edge.a, edge.b));
  tree_ = std::make_shared<const BoxTree>(boxes);
}

/// Calls `visit(edge)` for all edges whose boxes touch one, in their order, and for others where
/// there are few.
template <typename Visit>
void Polygons::forEachEdgeIn(const Box& box, Visit&& visit) const {
  if (!tree_) {
    for (const Edge& edge : edges_) visit(edge);
    return;
  }
  std::vector<std::uint32_t> found;
  tree_->query(grown(box, kRounding), [&](std::uint32_t i) { found.push_back(i); });
  std::ranges::sort(found);
  for (const std::uint32_t i : found) visit(edges_[i]);
}

std::vector<std::vector<Vec2>> Polygons::loops() const {
  std::vector<std::vector<Vec2>> polygons(endsOfOthers_.size() + 1);
  std::size_t i = 0;
  for (std::size_t k = 0; k < polygons.size(); ++k)
    for (const std::size_t end = k < endsOfOthers_.size() ? endsOfOthers_[k] : edges_.size();
         i < end; ++i)
      polygons[k].push_back(edges_[i].a);
  return polygons;
}

bool Polygons::contains(Vec2 p) const {
  bool inside = false;
  bool isOnEdge = false;
  forEachEdgeIn({{-kFar, p.y}, p}, [&](const Edge& edge) {
    const auto& [a, b] = edge;
    isOnEdge |= a == p;
    if (isOnEdge || (a.y <= p.y) == (b.y <= p.y)) return;
    if (std::min(a.x, b.x) > p.x) return;
    if (std::max(a.x, b.x) < p.x) {
      inside = !inside;
      return;
    }
    const int side = orientation(a, b, p);
    isOnEdge |= side == 0;
    if ((side > 0) == (b.y <= p.y)) inside = !inside;
  });
  return inside || isOnEdge;
}

Vec2 Polygons::nearest(Vec2 p) const {
  Vec2 best = edges_.front().a;
  double distance = kFar;
  for (double reach = tree_ ? 1 : kFar; true; reach *= 2) {
    forEachEdgeIn(grown({p, p}, reach), [&](const Edge& edge) {
      if (distanceToBox(edge, p) > distance) return;
      const Vec2 q = nearestOnSegment(edge.a, edge.b, p);
      const double found = length(q - p);
      if (found < distance) best = q, distance = found;
    });
    if (distance <= reach) return best;
  }
}

bool Polygons::mayMeet(const Box& box) const {
  bool isCut = false;
  forEachEdgeIn(box, [&](const Edge& edge) { isCut |= touch(boxOf(edge.a, edge.b), box); });
  return isCut || contains(box.min);
}

double Polygons::areaNear(double margin) const {
  double twiceInside = 0;
  double border = 0;
  for (const auto& [a, b] : edges_) {
    twiceInside += cross(a - edges_.front().a, b - edges_.front().a);
    border += length(b - a);
  }
  return std::abs(twiceInside) / 2 + margin * border;
}

Polygons::EdgesNear Polygons::edgesWithin(Vec2 p, double reach,
                                          std::pmr::memory_resource& memory) const {
  constexpr std::size_t kFew = 8;
  EdgesNear edges(&memory);
  edges.reserve(kFew);
  forEachEdgeIn(grown({p, p}, reach), [&](const Edge& edge) {
    if (edge.isWithin(reach, p)) edges.push_back(edge);
  });
  return edges;
}

void Polygons::findAroundRow(double row, double reach, Polygons& around) const {
  around.edges_.clear();
  forEachEdgeIn({{-kFar, row - reach}, {kFar, row + reach}}, [&](const Edge& edge) {
    if (std::min(edge.a.y, edge.b.y) - row <= reach && row - std::max(edge.a.y, edge.b.y) <= reach)
      around.edges_.push_back(edge);
  });
}

/// What of a row lies beside an edge, if any does.
std::optional<Polygons::Beside> Polygons::besideEdge(const Edge& edge, double row, double margin) {
  const Vec2 a = edge.a;
  const Vec2 b = edge.b;
  const double low = std::max(std::min(a.y, b.y), row - margin);
  const double high = std::min(std::max(a.y, b.y), row + margin);
  if (low > high) return std::nullopt;
  const auto xAt = [&a, &b](double y) { return std::lerp(a.x, b.x, (y - a.y) / (b.y - a.y)); };
  const bool isLevel = a.y == b.y;
  const double ends[] = {isLevel ? a.x : xAt(low), isLevel ? b.x : xAt(high)};
  return Beside{{std::min(ends[0], ends[1]) - margin, std::max(ends[0], ends[1]) + margin},
                (a.y <= row) != (b.y <= row)};
}

/// Of a row, in rising order and apart, at the front of what is given. Between two of these all is
/// inside, or all is outside: as many edges cross the row before as tell.
std::span<Polygons::Beside> Polygons::joined(std::span<Beside> beside) {
  std::ranges::sort(beside, {}, [](const Beside& part) { return part.part.from; });
  std::size_t apart = 0;
  bool isInside = false;
  for (const Beside& next : beside) {
    isInside ^= next.leadsInside;
    if (apart == 0 || beside[apart - 1].part.to < next.part.from)
      beside[apart++].part = next.part;
    else
      beside[apart - 1].part.to = std::max(beside[apart - 1].part.to, next.part.to);
    beside[apart - 1].leadsInside = isInside;
  }
  return beside.first(apart);
}

void Polygons::findBeside(double row, double margin, std::vector<Beside>& beside) const {
  beside.clear();
  forEachEdgeIn({{-kFar, row - margin}, {kFar, row + margin}}, [&](const Edge& edge) {
    if (const auto found = besideEdge(edge, row, margin)) beside.push_back(*found);
  });
  beside.resize(joined(beside).size());
}

/// Edge by edge, so that no row looks at edges elsewhere.
ListPerRow<Polygons::Beside> Polygons::besideEdgesInRows(double firstRow, int rows,
                                                         double margin) const {
  std::vector<std::pair<int, Beside>> found;
  for (const Edge& edge : edges_) {
    // One more at either end, so that rounding leaves out none.
    const auto rowAt = [&](double y, int more) {
      return static_cast<int>(std::clamp(std::floor(y - firstRow) + more, 0.0, rows * 1.0));
    };
    const int end = rowAt(std::max(edge.a.y, edge.b.y) + margin, 2);
    for (int row = rowAt(std::min(edge.a.y, edge.b.y) - margin, -1); row < end; ++row)
      if (const auto beside = besideEdge(edge, firstRow + row, margin))
        found.emplace_back(row, *beside);
  }
  return {rows, found};
}

ListPerRow<Polygons::Stretch> Polygons::nearAlongRows(double firstRow, int rows,
                                                      double margin) const {
  ListPerRow<Beside> besideRows = besideEdgesInRows(firstRow, rows, margin);
  ListPerRow<Stretch> nearRows;
  for (int row = 0; row < rows; ++row) {
    nearRows.addRow();
    std::optional<Stretch> near;
    for (const Beside& next : joined(besideRows.row(row))) {
      near = {near ? near->from : next.part.from, next.part.to};
      if (next.leadsInside) continue;
      nearRows.add(*near);
      near.reset();
    }
  }
  return nearRows;
}

}  // namespace hearth
