#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "level/locate.h"
#include "lint/lint.h"
#include "lint/sector_graph.h"
#include "math/box_tree.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// What the loader takes for noise, so many times: at most half a centimetre, or a 200th of the
/// shortest edge concerned. Things that are meant not to touch are set a centimetre apart.
constexpr double kHairOfNoise = 5;

/// Cosine of the turn from one wall to the next but one from which on they run back along each
/// other: then the short wall between is the end of something thin, which is meant.
constexpr double kRunsBack = -0.9;

BoxTree treeOf(const Outlines& outlines) {
  std::vector<Box> boxes;
  for (const Edge& edge : outlines.edges) boxes.push_back(outlines.box(edge));
  return BoxTree(boxes);
}

class NearMissFinder {
 public:
  NearMissFinder(const LintedLevel& linted, Findings& findings)
      : level_(linted.level()),
        source_(linted.source),
        outlines_(linted.source.outlines),
        findings_(findings),
        linked_(undirected(sectorGraph(level_))),
        edges_(treeOf(outlines_)) {}

  void lookAtSectors() {
    for (const OutlineSector& sector : outlines_.sectors)
      for (const OutlineLoop& loop : sector.loops)
        for (std::uint32_t i = 0; i < loop.edgeCount; ++i)
          lookAtVertex({loop.firstEdge + (i + loop.edgeCount - 1) % loop.edgeCount,
                        loop.firstEdge + i, loop.firstEdge + (i + 1) % loop.edgeCount});
  }

 private:
  /// The edge that ends in a vertex, the one that starts there, and the one after that.
  struct Corner {
    std::uint32_t before;
    std::uint32_t after;
    std::uint32_t next;
  };

  struct Miss {
    double distance;
    std::uint32_t edge;
    Vec2 point;  ///< of the edge
  };

  Vec2 directionOf(std::uint32_t edge) const {
    const Edge& of = outlines_.edges[edge];
    return (1 / outlines_.length(of)) * (outlines_.to(of) - outlines_.from(of));
  }

  double lengthOf(std::uint32_t edge) const { return outlines_.length(outlines_.edges[edge]); }

  static bool isHair(double distance, double shortestEdge) {
    const double noise = noiseOf(shortestEdge);
    return distance > noise && distance < kHairOfNoise * noise;
  }

  void lookAtVertex(const Corner& corner) {
    lookAtShortWall(corner);
    const Edge& edge = outlines_.edges[corner.after];
    const Vec2 p = outlines_.from(edge);
    const double shortest = std::min(lengthOf(corner.before), lengthOf(corner.after));
    std::optional<Miss> nearest;
    edges_.query(grown(boxOf(p, p), kHairOfNoise * kAuthorNoise), [&](std::uint32_t other) {
      const std::optional<Miss> miss = missOf(edge.sector, p, shortest, other);
      if (miss && (!nearest || std::tie(miss->distance, miss->edge) <
                                   std::tie(nearest->distance, nearest->edge)))
        nearest = miss;
    });
    if (nearest) report(edge, *nearest);
  }

  /// An end of the other edge where that is missed, else a point between.
  std::optional<Miss> missOf(std::uint32_t sector, Vec2 p, double shortest,
                             std::uint32_t other) const {
    const Edge& wall = outlines_.edges[other];
    const Vec2 a = outlines_.from(wall);
    const Vec2 b = outlines_.to(wall);
    if (!mayMeet(sector, wall.sector) || a == p || b == p) return std::nullopt;
    shortest = std::min(shortest, lengthOf(other));
    Vec2 point = nearestOnSegment(a, b, p);
    for (const Vec2 end : {a, b})
      if (isHair(length(end - p), shortest)) point = end;
    const double distance = length(point - p);
    if (!isHair(distance, shortest)) return std::nullopt;
    if (sector == wall.sector && !hasAirBetween(sector, p, point)) return std::nullopt;
    return Miss{distance, other, point};
  }

  bool mayMeet(std::uint32_t sector, std::uint32_t other) const {
    return sector == other || std::ranges::binary_search(linked_[sector], SectorId(other));
  }

  /// Else what is thin there is solid: a pane, or a board.
  bool hasAirBetween(std::uint32_t sector, Vec2 p, Vec2 q) const {
    return contains(level_, level_.sectors[sector], lerp(p, q, 0.5));
  }

  /// A wall that is as short as a hair joins two vertices that were one.
  void lookAtShortWall(const Corner& corner) {
    const double shortest = std::min(lengthOf(corner.before), lengthOf(corner.next));
    if (!isHair(lengthOf(corner.after), shortest)) return;
    if (dot(directionOf(corner.before), directionOf(corner.next)) < kRunsBack) return;
    const Edge& edge = outlines_.edges[corner.after];
    report(edge, {lengthOf(corner.after), corner.after, outlines_.to(edge)});
  }

  /// Once for each point: many vertices may lie in it, and what it misses misses it.
  void report(const Edge& edge, const Miss& miss) {
    const Vec2 p = outlines_.from(edge);
    if (reported_.contains(p) || reported_.contains(miss.point)) return;
    reported_.insert({p, miss.point});
    const Edge& wall = outlines_.edges[miss.edge];
    const bool isVertex = miss.point == outlines_.from(wall) || miss.point == outlines_.to(wall);
    findings_.add(
        FindingKind::NearMiss, source_.vertexPlace(edge, edge.from),
        fmt::format("the vertex ({}, {}) misses {} ({:.7g}, {:.7g}) of sector \"{}\" by {:.2g} mm",
                    p.x, p.y, isVertex ? "the vertex" : "a wall at", miss.point.x, miss.point.y,
                    level_.sectors[wall.sector].name, 1000 * miss.distance),
        "give both the same coordinates, or move them well apart");
  }

  const Level& level_;
  const LevelSource& source_;
  const Outlines& outlines_;
  Findings& findings_;
  std::vector<std::vector<SectorId>> linked_;
  BoxTree edges_;
  std::set<Vec2, decltype(&lessXY)> reported_{&lessXY};
};

}  // namespace

void findNearMisses(const LintedLevel& linted, Findings& findings) {
  NearMissFinder(linted, findings).lookAtSectors();
}

}  // namespace hearth
