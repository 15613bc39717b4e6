#include "load/link/weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "math/tolerance.h"

namespace hearth {

Welder::Welder(const Outlines& outlines)
    : outlines_(outlines),
      parent_(outlines.points.size()),
      partners_(outlines.edges.size()),
      points_(outlines.edges.size()) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

Welder::Line Welder::lineOf(std::uint32_t edge) const {
  const Vec2 start = outlines_.from(outlines_.edges[edge]);
  const Vec2 span = outlines_.to(outlines_.edges[edge]) - start;
  const double length = hearth::length(span);
  return {start, (1 / length) * span, length};
}

void Welder::pairIfAlong(std::uint32_t a, std::uint32_t b) {
  if (a == b) return;
  if (a > b) std::swap(a, b);  // so that both orders decide alike
  const Line lineA = lineOf(a);
  const Line lineB = lineOf(b);
  const double noise = noiseOf(std::min(lineA.length, lineB.length));
  const Vec2 end = lineB.start + lineB.length * lineB.direction;
  double alongStart = lineA.along(lineB.start);
  double alongEnd = lineA.along(end);
  const double from = std::clamp(std::min(alongStart, alongEnd), 0.0, lineA.length);
  const double to = std::clamp(std::max(alongStart, alongEnd), 0.0, lineA.length);
  if (to - from <= noise) return;

  // The gap between two lines is largest at an end of their common range.
  const double slope = (lineA.beside(end) - lineA.beside(lineB.start)) / (alongEnd - alongStart);
  const auto gapAt = [&](double s) {
    return std::abs(lineA.beside(lineB.start) + slope * (s - alongStart));
  };
  if (gapAt(from) > noise || gapAt(to) > noise) return;

  const double b0 = lineB.along(lineA.start + from * lineA.direction);
  const double b1 = lineB.along(lineA.start + to * lineA.direction);
  partners_[a].push_back({b, from, to, noise, 0});
  partners_[b].push_back({a, std::min(b0, b1), std::max(b0, b1), noise, 0});
}

void Welder::addTouch(const Touch& touch) { touches_.push_back(touch); }

Weld Welder::finish() {
  for (std::vector<Partner>& partners : partners_) sortPartners(partners);
  for (const Touch& touch : touches_) insert(touch.edge, touch.vertex, touch.noise);
  for (std::uint32_t edge = 0; edge < outlines_.edges.size(); ++edge) {
    handOn({edge, outlines_.edges[edge].from});
    handOn({edge, outlines_.edges[edge].to});
  }
  while (!arrivals_.empty()) {
    const Arrival arrival = arrivals_.front();
    arrivals_.pop_front();
    handOn(arrival);
  }

  Weld weld;
  for (std::uint32_t vertex = 0; vertex < parent_.size(); ++vertex)
    weld.representative.push_back(find(vertex));
  for (std::uint32_t edge = 0; edge < outlines_.edges.size(); ++edge)
    weld.splits.push_back(splitsOf(edge));
  return weld;
}

void Welder::sortPartners(std::vector<Partner>& partners) const {
  std::sort(partners.begin(), partners.end(), [](const Partner& a, const Partner& b) {
    return a.from != b.from ? a.from < b.from : a.edge < b.edge;
  });
  double reach = -std::numeric_limits<double>::infinity();
  for (Partner& partner : partners) {
    reach = std::max(reach, partner.to + partner.noise);
    partner.reach = reach;
  }
}

/// Gives a point of an edge to all its partners along which the point lies.
void Welder::handOn(Arrival arrival) {
  const std::vector<Partner>& partners = partners_[arrival.edge];
  if (partners.empty()) return;
  const double s = lineOf(arrival.edge).along(outlines_.points[arrival.vertex]);
  auto partner =
      std::upper_bound(partners.begin(), partners.end(), s + kAuthorNoise,  // no noise is larger
                       [](double value, const Partner& other) { return value < other.from; });
  while (partner != partners.begin() && (--partner)->reach >= s)
    if (s >= partner->from - partner->noise && s <= partner->to + partner->noise)
      insert(partner->edge, arrival.vertex, partner->noise);
}

void Welder::insert(std::uint32_t edge, std::uint32_t vertex, double noise) {
  const Line line = lineOf(edge);
  const double s = line.along(outlines_.points[vertex]);
  if (s <= noise) return unite(vertex, outlines_.edges[edge].from);
  if (s >= line.length - noise) return unite(vertex, outlines_.edges[edge].to);
  std::map<double, std::uint32_t>& points = points_[edge];
  const auto near = points.lower_bound(s - noise);
  if (near != points.end() && near->first <= s + noise) return unite(vertex, near->second);
  points.emplace(s, vertex);
  arrivals_.push_back({edge, vertex});
}

std::uint32_t Welder::find(std::uint32_t vertex) {
  while (parent_[vertex] != vertex) {
    parent_[vertex] = parent_[parent_[vertex]];
    vertex = parent_[vertex];
  }
  return vertex;
}

void Welder::unite(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  parent_[std::max(a, b)] = std::min(a, b);
}

/// Points that were united after both had been inserted are one point here; what lies between
/// them is within the noise of it, too.
std::vector<std::uint32_t> Welder::splitsOf(std::uint32_t edge) {
  if (points_[edge].empty()) return {};
  const std::uint32_t end = find(outlines_.edges[edge].to);
  std::vector<std::uint32_t> path{find(outlines_.edges[edge].from)};
  std::unordered_map<std::uint32_t, std::size_t> lengthUpTo{{path[0], 1}};
  for (const auto& [s, vertex] : points_[edge]) {
    const std::uint32_t point = find(vertex);
    if (point == end) break;
    const auto [earlier, isNew] = lengthUpTo.emplace(point, path.size() + 1);
    if (isNew) {
      path.push_back(point);
      continue;
    }
    while (path.size() > earlier->second) {
      lengthUpTo.erase(path.back());
      path.pop_back();
    }
  }
  path.erase(path.begin());
  return path;
}

}  // namespace hearth
