#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "load/link/outline.h"
#include "load/validate/hole_places.h"
#include "math/predicates.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

double distanceTo(Vec2 a, Vec2 b, Vec2 p) { return length(nearestOnSegment(a, b, p) - p); }

/// Looks for mistakes in the loops of one sector.
class SectorChecker {
 public:
  SectorChecker(Report& report, const SectorDescription& description, Outlines& outlines,
                OutlineSector& sector)
      : report_(report),
        description_(description),
        outlines_(outlines),
        sector_(sector),
        tree_(outlines.treeOf(sector)) {}

  void check() {
    for (const OutlineLoop& loop : sector_.loops) checkShape(loop);
    if (!sector_.isSound) return;
    findTouches();
    if (!sector_.isSound) return;
    findCrossings();
    if (!sector_.isSound) return;
    for (const OutlineLoop& loop : sector_.loops)
      if (hasNoArea(loop)) failForArea(loop);
    if (!sector_.isSound) return;
    checkHolePlaces(
        outlines_, sector_, tree_, [&](std::uint32_t hole) { return touching_.contains(hole); },
        [&](std::uint32_t hole) { return isInPlace(hole); });
    checkArea();
    if (!sector_.isSound) return;
    for (const OutlineLoop& loop : sector_.loops)
      if (loop.isTurned) warnOfDirection(loop);
  }

 private:
  const LoopDescription& described(const OutlineLoop& loop) const {
    return description_.loops[loop.described];
  }
  const OutlineLoop& loopOf(const Edge& edge) const { return sector_.loops[edge.loop]; }
  const Edge& edge(std::uint32_t inSector) const {
    return outlines_.edges[sector_.firstEdge + inSector];
  }
  /// Where the file gives a vertex.
  Place placeOf(const OutlineLoop& loop, std::uint32_t vertex) const {
    return described(loop).vertexPlaces[vertex - loop.firstVertex];
  }
  Place wallPlace(const Edge& edge) const {
    const OutlineLoop& loop = loopOf(edge);
    return placeOf(loop, loop.firstVertex + edge.wallIndex);
  }
  std::string wallName(const Edge& edge) const {
    return fmt::format("wall {} of loop \"{}\"", edge.wallIndex, described(loopOf(edge)).name);
  }
  std::string ends(const Edge& edge) const { return described(loopOf(edge)).ends(edge.wallIndex); }
  std::string vertexName(const OutlineLoop& loop, std::uint32_t vertex) const {
    return fmt::format("vertex {} of loop \"{}\"", vertex - loop.firstVertex, described(loop).name);
  }
  void fail(Place place, std::string message, std::string advice) {
    report_.error(place, std::move(message), std::move(advice));
    sector_.isSound = false;
  }

  /// A point of a loop that tells where the loop lies, and how near to another loop it counts as
  /// lying on that.
  struct Probe {
    Vec2 p;
    double noise;
  };

  void checkShape(const OutlineLoop& loop);
  double shortestEdge(const OutlineLoop& loop) const;
  bool hasNoArea(const OutlineLoop& loop) const;
  bool liesInLine(const OutlineLoop& loop) const;
  void failForArea(const OutlineLoop& loop);
  void findTouches();
  void findTouchesOf(const Edge& incoming, std::uint32_t vertex, double noise);
  std::string adviceOnTouch(const OutlineLoop& loop, std::uint32_t vertex, const Edge& other) const;
  void reportSelfTouch(const OutlineLoop& loop, std::uint32_t vertex, const Edge& other,
                       std::uint32_t nearEnd);
  void findCrossings();
  void failForCrossing(const Edge& a, const Edge& b);
  bool doCross(const Edge& a, const Edge& b) const;
  bool isInPlace(std::size_t hole);
  std::vector<Probe> probesOf(std::size_t loop) const;
  std::map<std::uint32_t, bool> loopsAround(Vec2 p) const;
  bool isOnWallOf(std::uint32_t loop, Probe probe) const;
  std::optional<std::uint32_t> twinOf(std::size_t hole, const std::vector<Probe>& probes);
  void checkArea();
  void warnOfDirection(const OutlineLoop& loop) const;

  Report& report_;
  const SectorDescription& description_;
  Outlines& outlines_;
  OutlineSector& sector_;
  BoxTree tree_;
  /// Of each edge of the sector that something touches: fractions of its length.
  std::map<std::uint32_t, std::vector<double>> touchFractions_;
  std::map<std::uint32_t, std::set<std::uint32_t>> touching_;  // loops, by loop
  std::set<std::pair<std::uint32_t, std::uint32_t>> repeats_;  // reported pairs of vertices
};

/// What a loop alone can get wrong except touching and crossing.
void SectorChecker::checkShape(const OutlineLoop& loop) {
  for (std::uint32_t i = 0; i < loop.edgeCount; ++i) {
    const Edge& wall = outlines_.edges[loop.firstEdge + i];
    if (outlines_.length(wall) < kShortestWall) {
      if (wall.wallIndex + 1 == loop.edgeCount)
        return fail(placeOf(loop, loop.firstVertex + wall.wallIndex),
                    fmt::format("{} repeats the first",
                                vertexName(loop, loop.firstVertex + wall.wallIndex)),
                    "remove it: the last wall of a loop leads back to its first vertex");
      const std::uint32_t second = loop.firstVertex + wall.wallIndex + 1;
      return fail(placeOf(loop, second),
                  fmt::format("{} repeats the one before it", vertexName(loop, second)),
                  fmt::format("remove it, or move it at least {} m away", kShortestWall));
    }
  }
  if (liesInLine(loop)) failForArea(loop);
}

double SectorChecker::shortestEdge(const OutlineLoop& loop) const {
  double shortest = kEndless;
  for (std::uint32_t i = 0; i < loop.edgeCount; ++i)
    shortest = std::min(shortest, outlines_.length(outlines_.edges[loop.firstEdge + i]));
  return shortest;
}

/// Whether the two sides of a loop are no farther apart than noise. A loop that crosses itself may
/// seem so, too, as what it runs round the wrong way counts against the rest.
bool SectorChecker::hasNoArea(const OutlineLoop& loop) const {
  double perimeter = 0;
  for (std::uint32_t i = 0; i < loop.edgeCount; ++i)
    perimeter += outlines_.length(outlines_.edges[loop.firstEdge + i]);
  return std::abs(loop.twiceArea) <= noiseOf(shortestEdge(loop)) * perimeter;
}

bool SectorChecker::liesInLine(const OutlineLoop& loop) const {
  const std::span<const Vec2> vertices(&outlines_.points[loop.firstVertex], loop.edgeCount);
  const auto fromFirst = [&](Vec2 p) { return length(p - vertices.front()); };
  const Vec2 last = *std::ranges::max_element(vertices, {}, fromFirst);
  const double noise = noiseOf(shortestEdge(loop));
  return std::ranges::all_of(
      vertices, [&](Vec2 p) { return distanceTo(vertices.front(), last, p) <= noise; });
}

void SectorChecker::failForArea(const OutlineLoop& loop) {
  fail(described(loop).place, fmt::format("loop \"{}\" encloses no area", described(loop).name),
       "spread its vertices out");
}

void SectorChecker::findTouches() {
  for (std::uint32_t l = 0; l < sector_.loops.size(); ++l) {
    const OutlineLoop& loop = sector_.loops[l];
    for (std::uint32_t i = 0; i < loop.edgeCount; ++i) {
      const Edge& incoming = outlines_.edges[loop.firstEdge + i];
      const Edge& outgoing = outlines_.edges[loop.firstEdge + (i + 1) % loop.edgeCount];
      const double noise =
          noiseOf(std::min(outlines_.length(incoming), outlines_.length(outgoing)));
      findTouchesOf(incoming, incoming.to, noise);
    }
  }
}

/// All edges that do not end in the vertex (where `incoming` does) but come within the noise of it.
void SectorChecker::findTouchesOf(const Edge& incoming, std::uint32_t vertex, double noise) {
  const Vec2 p = outlines_.points[vertex];
  const OutlineLoop& loop = loopOf(incoming);
  const auto noiseWith = [&](const Edge& other) {
    return std::min(noise, noiseOf(outlines_.length(other)));
  };
  std::vector<std::uint32_t> found;
  tree_.query(grown({p, p}, noise), [&](std::uint32_t i) {
    const Edge& other = edge(i);
    if (other.from == vertex || other.to == vertex) return;
    const double least = noiseWith(other);
    if (distanceTo(outlines_.from(other), outlines_.to(other), p) <= least) found.push_back(i);
  });
  std::sort(found.begin(), found.end());
  for (const std::uint32_t i : found) {
    const Edge& other = edge(i);
    const Vec2 a = outlines_.from(other);
    const Vec2 b = outlines_.to(other);
    if (other.loop == incoming.loop)
      return reportSelfTouch(loop, vertex, other,
                             length(a - p) < length(b - p) ? other.from : other.to);
    outlines_.touches.push_back({sector_.firstEdge + i, vertex, noiseWith(other)});
    touchFractions_[i].push_back(dot(p - a, b - a) / dot(b - a, b - a));
    touching_[incoming.loop].insert(other.loop);
    touching_[other.loop].insert(incoming.loop);
  }
}

/// Of a vertex on the wall before the one that leads to it.
std::string SectorChecker::adviceOnTouch(const OutlineLoop& loop, std::uint32_t vertex,
                                         const Edge& other) const {
  const std::uint32_t here = vertex - loop.firstVertex;
  const std::uint32_t before = (here + loop.edgeCount - 1) % loop.edgeCount;
  const bool turnsBack = (other.wallIndex + 1) % loop.edgeCount == before;
  if (!turnsBack) return "move it off that wall, or cut the loop in two";
  return fmt::format("move it off that wall, or swap it with vertex {}: the loop turns back there",
                     before);
}

void SectorChecker::reportSelfTouch(const OutlineLoop& loop, std::uint32_t vertex,
                                    const Edge& other, std::uint32_t nearEnd) {
  const Vec2 p = outlines_.points[vertex];
  if (length(outlines_.points[nearEnd] - p) > noiseOf(outlines_.length(other)))
    return fail(placeOf(loop, vertex),
                fmt::format("{} lies on wall {} of its own loop", vertexName(loop, vertex),
                            other.wallIndex),
                adviceOnTouch(loop, vertex, other));
  const auto [first, second] = std::minmax(vertex, nearEnd);
  if (repeats_.insert({first, second}).second)
    fail(placeOf(loop, second),
         fmt::format("{} repeats vertex {}", vertexName(loop, second), first - loop.firstVertex),
         "move it, or cut the loop in two");
}

/// Exact, except for end points that touch.
bool SectorChecker::doCross(const Edge& a, const Edge& b) const {
  const Vec2 a0 = outlines_.from(a);
  const Vec2 a1 = outlines_.to(a);
  const Vec2 b0 = outlines_.from(b);
  const Vec2 b1 = outlines_.to(b);
  if (orientation(a0, a1, b0) * orientation(a0, a1, b1) >= 0) return false;
  if (orientation(b0, b1, a0) * orientation(b0, b1, a1) >= 0) return false;
  const double noise = noiseOf(std::min(length(a1 - a0), length(b1 - b0)));
  return distanceTo(a0, a1, b0) > noise && distanceTo(a0, a1, b1) > noise &&
         distanceTo(b0, b1, a0) > noise && distanceTo(b0, b1, a1) > noise;
}

/// At most one message for each pair of loops.
void SectorChecker::findCrossings() {
  std::set<std::pair<std::uint32_t, std::uint32_t>> reported;
  for (std::uint32_t i = 0; i < sector_.edgeCount; ++i) {
    std::vector<std::uint32_t> crossed;
    tree_.query(outlines_.box(edge(i)), [&](std::uint32_t j) {
      if (j < i && doCross(edge(i), edge(j))) crossed.push_back(j);
    });
    std::sort(crossed.begin(), crossed.end());
    for (const std::uint32_t j : crossed)
      if (reported.insert({edge(j).loop, edge(i).loop}).second) failForCrossing(edge(i), edge(j));
  }
}

void SectorChecker::failForCrossing(const Edge& a, const Edge& b) {
  const Vec2 along = outlines_.to(a) - outlines_.from(a);
  const Vec2 other = outlines_.to(b) - outlines_.from(b);
  const double fraction = cross(outlines_.from(b) - outlines_.from(a), other) / cross(along, other);
  const Vec2 p = outlines_.from(a) + fraction * along;
  fail(wallPlace(a),
       fmt::format("{}, {}, crosses {}, {}, in ({:.7g}, {:.7g})", wallName(a), ends(a), wallName(b),
                   ends(b), p.x, p.y),
       "move their vertices");
}

/// Whether `p` lies within each loop that a ray from it towards +x meets.
std::map<std::uint32_t, bool> SectorChecker::loopsAround(Vec2 p) const {
  std::map<std::uint32_t, bool> isInside;
  tree_.query({p, {kEndless, p.y}}, [&](std::uint32_t i) {
    const Vec2 a = outlines_.from(edge(i));
    const Vec2 b = outlines_.to(edge(i));
    if ((a.y <= p.y) == (b.y <= p.y)) return;
    if ((orientation(a, b, p) > 0) == (b.y > p.y)) isInside[edge(i).loop] ^= true;
  });
  return isInside;
}

bool SectorChecker::isOnWallOf(std::uint32_t loop, Probe probe) const {
  bool isOn = false;
  tree_.query(grown({probe.p, probe.p}, probe.noise), [&](std::uint32_t i) {
    const Edge& wall = edge(i);
    isOn |= wall.loop == loop &&
            distanceTo(outlines_.from(wall), outlines_.to(wall), probe.p) <= probe.noise;
  });
  return isOn;
}

/// Of a loop that crosses no other: any vertex; or where it touches others, the middle of each part
/// between two touches.
std::vector<SectorChecker::Probe> SectorChecker::probesOf(std::size_t l) const {
  const OutlineLoop& loop = sector_.loops[l];
  if (!touching_.contains(static_cast<std::uint32_t>(l)))
    return {{outlines_.points[loop.firstVertex], 0}};
  std::vector<Probe> probes;
  for (std::uint32_t i = loop.firstEdge; i < loop.firstEdge + loop.edgeCount; ++i) {
    const Edge& wall = outlines_.edges[i];
    std::vector<double> fractions{0, 1};
    if (const auto found = touchFractions_.find(i - sector_.firstEdge);
        found != touchFractions_.end())
      fractions.insert(fractions.end(), found->second.begin(), found->second.end());
    std::sort(fractions.begin(), fractions.end());
    const double length = outlines_.length(wall);
    const double noise = 2 * noiseOf(length);
    for (std::size_t k = 1; k < fractions.size(); ++k)
      if ((fractions[k] - fractions[k - 1]) * length > noise)
        probes.push_back(
            {lerp(outlines_.from(wall), outlines_.to(wall), (fractions[k] + fractions[k - 1]) / 2),
             noise});
  }
  return probes;
}

/// Whether a hole lies inside the border and outside the other holes; reported where not.
bool SectorChecker::isInPlace(std::size_t hole) {
  const LoopDescription& loop = described(sector_.loops[hole]);
  const std::vector<Probe> probes = probesOf(hole);
  for (const Probe probe : probes) {
    std::map<std::uint32_t, bool> around = loopsAround(probe.p);
    around.erase(static_cast<std::uint32_t>(hole));
    if (!around[0] && !isOnWallOf(0, probe)) {
      fail(loop.place, fmt::format("loop \"{}\" leaves the border", loop.name),
           "move it inside the border");
      return false;
    }
    for (const auto& [other, isInside] : around)
      if (other != 0 && isInside && !isOnWallOf(other, probe)) {
        fail(loop.place,
             fmt::format("loop \"{}\" lies within loop \"{}\"", loop.name,
                         described(sector_.loops[other]).name),
             "remove one of them");
        return false;
      }
  }
  const std::optional<std::uint32_t> twin = twinOf(hole, probes);
  if (twin)
    fail(loop.place,
         fmt::format("loop \"{}\" has the outline of loop \"{}\"", loop.name,
                     described(sector_.loops[*twin]).name),
         "remove one of them");
  return !twin;
}

/// The first hole that has the outline of a later one: they touch everywhere, and nothing of one
/// lies inside the other.
std::optional<std::uint32_t> SectorChecker::twinOf(std::size_t hole,
                                                   const std::vector<Probe>& probes) {
  for (const std::uint32_t other : touching_[static_cast<std::uint32_t>(hole)])
    if (other != 0 && other < hole && std::all_of(probes.begin(), probes.end(), [&](Probe probe) {
          return isOnWallOf(other, probe);
        }))
      return other;
  return std::nullopt;
}

void SectorChecker::checkArea() {
  double border = std::abs(sector_.loops[0].twiceArea);
  double holes = 0;
  for (std::size_t i = 1; i < sector_.loops.size(); ++i)
    holes += std::abs(sector_.loops[i].twiceArea);
  if (sector_.isSound && holes >= border * (1 - kAreaNoise))
    fail(description_.place,
         fmt::format("the holes of sector \"{}\" leave no area", description_.name),
         "make them smaller");
}

void SectorChecker::warnOfDirection(const OutlineLoop& loop) const {
  const LoopDescription& turned = described(loop);
  const bool isBorder = &loop == &sector_.loops[0];
  const bool hasWalls = turned.walls.size() > 1;
  report_.warning(turned.place,
                  fmt::format("loop \"{}\" runs the wrong way and is turned round", turned.name),
                  fmt::format("list the vertices of a {} on a map with y down{}",
                              isBorder ? "border clockwise" : "hole counter-clockwise",
                              hasWalls ? ", and the walls as they follow then" : ""),
                  "turned-loop");
}

}  // namespace

void validateOutlines(Report& report, const LevelDescription& description, Outlines& outlines) {
  for (std::size_t i = 0; i < outlines.sectors.size(); ++i)
    if (outlines.sectors[i].isSound)
      SectorChecker(report, description.sectors[i], outlines, outlines.sectors[i]).check();
}

}  // namespace hearth
