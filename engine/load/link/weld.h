#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "load/link/outline.h"

namespace hearth {

/// What welding found, on top of the outlines it was given.
struct Weld {
  /// For each vertex the one whose coordinates it takes: the first in the file of all that
  /// coincide. Vertices with one representative are one point, to the bit.
  std::vector<std::uint32_t> representative;
  /// For each edge the representatives of the points that split it, in order, without its ends.
  std::vector<std::vector<std::uint32_t>> splits;
};

/// Makes the outlines of linked sectors fit together exactly: afterwards, wherever two paired edges
/// run along each other, both consist of the same pieces with the same end points.
///
/// Method. Every vertex of an edge's partner that lies on the edge becomes a *split point* of it,
/// and every split point of an edge is handed on to all partners along which it lies. That repeats
/// until nothing is new; it ends because split points are always vertices of the file and an edge
/// takes each at most once. A point that comes within the noise of an end of the edge, or of a
/// split point that it has, is united with it instead (union-find), which is what welds vertices
/// that miss each other by less than an author can mean. Whether a point lies along a pair is
/// decided once, when the pair is made; afterwards only its distance along the edge counts. So both
/// edges of a pair always agree on the points between their common ends: agreement does not
/// depend on a rounded distance being compared with a tolerance twice.
///
/// Cost: O(log n) for each point and each edge it lies on, while few partners of an edge overlap.
class Welder {
 public:
  explicit Welder(const Outlines& outlines);

  /// Pairs two edges if they run along each other, within the noise, for more than the noise.
  /// `a` and `b` may come in either order; a pair may be added again.
  void pairIfAlong(std::uint32_t a, std::uint32_t b);
  /// Splits `edge` at a vertex that lies on it within the noise.
  void addTouch(const Touch& touch);

  /// To be called once, after all pairs and touches were added.
  Weld finish();

 private:
  /// One edge of a pair as the other sees it: `from` to `to` metres along the other.
  struct Partner {
    std::uint32_t edge;
    double from;
    double to;
    double noise;  ///< metres
    double reach;  ///< the largest `to` up to this partner, once they are sorted by `from`
  };

  struct Line {
    Vec2 start;
    Vec2 direction;  ///< of length 1
    double length;
    double along(Vec2 p) const { return dot(p - start, direction); }
    double beside(Vec2 p) const { return cross(direction, p - start); }
  };

  struct Arrival {
    std::uint32_t edge;
    std::uint32_t vertex;
  };

  Line lineOf(std::uint32_t edge) const;
  void sortPartners(std::vector<Partner>& partners) const;
  void handOn(Arrival arrival);
  void insert(std::uint32_t edge, std::uint32_t vertex, double noise);
  std::uint32_t find(std::uint32_t vertex);
  void unite(std::uint32_t a, std::uint32_t b);
  std::vector<std::uint32_t> splitsOf(std::uint32_t edge);

  const Outlines& outlines_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::vector<Partner>> partners_;           // by edge
  std::vector<std::map<double, std::uint32_t>> points_;  // by edge: metres along it -> vertex
  std::vector<Touch> touches_;
  std::deque<Arrival> arrivals_;  // split points not yet handed on
};

}  // namespace hearth
