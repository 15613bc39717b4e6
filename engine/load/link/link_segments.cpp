#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "level/twins.h"
#include "load/link/walls_behind.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Pairs each edge with those that its segments must agree with.
class EdgePairer {
 public:
  EdgePairer(const Linking& linking, Welder& welder) : linking_(linking), welder_(welder) {}

  void pairPortals() {
    const std::vector<Edge>& edges = linking_.outlines.edges;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (!linking_.walls[i] || !linking_.outlines.sectors[edges[i].sector].isSound) continue;
      for (const SectorId target : targetsOf(*linking_.walls[i])) pairWithSector(i, target);
    }
  }

  /// The members of a flat portal need not be joined by walls, but their outlines cover the same
  /// area: edges running either way are paired.
  void pairFlatPortals() {
    for (const FlatPortal& flatPortal : linking_.level.flatPortals) {
      std::vector<std::uint32_t> edges;
      for (const SectorId member : flatPortal.upper) addEdgesOf(member, edges);
      for (const SectorId member : flatPortal.lower) addEdgesOf(member, edges);
      std::vector<Box> boxes;
      for (const std::uint32_t edge : edges) boxes.push_back(boxOfEdge(edge));
      const BoxTree tree(boxes);
      for (std::size_t i = 0; i < edges.size(); ++i)
        tree.query(grown(boxes[i], kAuthorNoise), [&](std::uint32_t j) {
          if (j < i) welder_.pairIfAlong(edges[i], edges[j]);
        });
    }
  }

 private:
  Box boxOfEdge(std::uint32_t edge) const {
    return linking_.outlines.box(linking_.outlines.edges[edge]);
  }

  Vec2 spanOf(std::uint32_t edge) const {
    const Outlines& outlines = linking_.outlines;
    return outlines.to(outlines.edges[edge]) - outlines.from(outlines.edges[edge]);
  }

  void addEdgesOf(SectorId sector, std::vector<std::uint32_t>& edges) const {
    const OutlineSector& outline = linking_.outlines.sectors[sector.index()];
    if (!outline.isSound) return;
    for (std::uint32_t i = 0; i < outline.edgeCount; ++i) edges.push_back(outline.firstEdge + i);
  }

  void pairWithSector(std::uint32_t edge, SectorId target) {
    const OutlineSector& sector = linking_.outlines.sectors[target.index()];
    if (!sector.isSound) return;
    const auto found = trees_.try_emplace(target.value, linking_.outlines, sector).first;
    found->second.tree.query(grown(boxOfEdge(edge), kAuthorNoise), [&](std::uint32_t i) {
      const std::uint32_t other = sector.firstEdge + i;
      if (dot(spanOf(edge), spanOf(other)) < 0) welder_.pairIfAlong(edge, other);
    });
  }

  struct SectorTree {
    SectorTree(const Outlines& outlines, const OutlineSector& sector)
        : tree(outlines.treeOf(sector)) {}
    BoxTree tree;
  };

  const Linking& linking_;
  Welder& welder_;
  std::unordered_map<std::uint32_t, SectorTree> trees_;
};

/// Makes segments of the welded outlines.
class SegmentBuilder {
 public:
  SegmentBuilder(Linking& linking, const Weld& weld) : linking_(linking), weld_(weld) {}

  void buildSector(std::uint32_t index) {
    const OutlineSector& outline = linking_.outlines.sectors[index];
    Sector& sector = linking_.level.sectors[index];
    if (!outline.isSound) return;
    sector.firstSegment = nextSegment();
    for (const OutlineLoop& loop : outline.loops) {
      const LoopDescription& described = linking_.description.sectors[index].loops[loop.described];
      Loop& built = sector.loops.emplace_back(Loop{described.name, nextSegment(), 0});
      for (std::uint32_t i = 0; i < loop.edgeCount; ++i) addEdge(loop.firstEdge + i);
      built.count = nextSegment().value - built.first.value;
    }
    sector.segmentCount = nextSegment().value - sector.firstSegment.value;
  }

 private:
  SegmentId nextSegment() const { return SegmentId(linking_.level.segments.size()); }
  Vec2 point(std::uint32_t vertex) const { return linking_.outlines.points[vertex]; }

  void addEdge(std::uint32_t index) {
    const Edge& edge = linking_.outlines.edges[index];
    const std::uint32_t from = weld_.representative[edge.from];
    const std::uint32_t to = weld_.representative[edge.to];
    if (from == to)
      return linking_.report.error(linking_.describedWall(edge).place,
                                   "both ends of the wall meet the same corner of its neighbours",
                                   "move them at least 1 mm apart");
    std::vector<std::uint32_t> path = weld_.splits[index];
    path.insert(path.begin(), from);
    path.push_back(to);
    // Where `s` is measured: along the authored wall from its first end.
    const Vec2 start = point(path.front());
    const Vec2 span = point(path.back()) - start;
    const double total = length(span);
    const auto sAt = [&](std::size_t i) {
      return i + 1 == path.size() ? total : dot(point(path[i]) - start, span) / total;
    };
    for (std::size_t i = 1; i < path.size(); ++i) {
      Segment segment;
      segment.p0 = point(path[i - 1]);
      segment.p1 = point(path[i]);
      segment.sector = SectorId(edge.sector);
      segment.loop = edge.loop;
      segment.wallIndex = edge.wallIndex;
      segment.sBefore = sAt(i - 1);
      segment.sAfter = total - sAt(i);
      segment.wall =
          linking_.walls[index] ? *linking_.walls[index] : Wall(Solid{linking_.textures.standIn()});
      linking_.level.segments.push_back(std::move(segment));
      linking_.edgeOf.push_back(index);
    }
  }

  Linking& linking_;
  const Weld& weld_;
};

/// Reports portals that have no wall of the next sector behind them, once for each authored wall,
/// and makes them solid.
class TwinChecker {
 public:
  explicit TwinChecker(Linking& linking)
      : linking_(linking), twins_(linking.level), behind_(linking) {}

  void check() {
    for (std::size_t i = 0; i < linking_.level.segments.size(); ++i)
      for (const SectorId target : targetsOf(linking_.level.segments[i].wall))
        if (!twins_.find(linking_.level.segments[i], target)) {
          reportOnce(SegmentId(i), target);
          linking_.level.segments[i].wall = Solid{linking_.textures.standIn()};
          break;
        }
  }

 private:
  void reportOnce(SegmentId id, SectorId target) {
    const std::uint32_t edge = linking_.edgeOf[id.index()];
    linking_.walls[edge].reset();
    if (!linking_.outlines.sectors[target.index()].isSound) return;
    if (!reported_.insert({&linking_.describedWall(id), target}).second) return;
    const Segment& segment = linking_.level[id];
    linking_.report.error(
        linking_.describedWall(id).place,
        fmt::format("the portal to sector \"{}\" does not lie on walls of that sector that run the "
                    "opposite way, from ({}, {}) to ({}, {})",
                    linking_.level[target].name, segment.p0.x, segment.p0.y, segment.p1.x,
                    segment.p1.y),
        adviceOn(id, target));
  }

  std::string adviceOn(SegmentId id, SectorId target) {
    if (linking_.report.isFull()) return "";
    const Segment& segment = linking_.level[id];
    const Edge& edge = linking_.outlines.edges[linking_.edgeOf[id.index()]];
    if (linking_.outlines.sectors[edge.sector].loops[edge.loop].isTurned)
      return "list the vertices of this loop the other way round first, it runs the wrong way";
    const std::vector<SectorId> behind = behind_.sectors(segment.sector, segment.p0, segment.p1);
    if (const auto meant = ledBackTo(segment.sector, target)) {
      const Edge& led = linking_.outlines.edges[linking_.edgeOf[meant->index()]];
      return fmt::format(
          "that sector leads back to wall {} of loop \"{}\", {}: give that one the \"next\"",
          led.wallIndex, linking_.describedLoop(led).name,
          linking_.describedLoop(led).ends(led.wallIndex));
    }
    if (!behind.empty() && std::ranges::find(behind, target) == behind.end())
      return fmt::format("a wall of sector \"{}\" lies there, did you mean that?",
                         linking_.level[behind.front()].name);
    const Vec2 from = linking_.outlines.from(edge);
    const Vec2 to = linking_.outlines.to(edge);
    if (isSliver(segment, length(to - from)))
      return fmt::format(
          "give both sectors the same point there: ({}, {}) misses ({}, {}) by {:.2g} m",
          segment.p0.x, segment.p0.y, segment.p1.x, segment.p1.y, length(segment.p1 - segment.p0));
    if (const auto missed = missedPoint(linking_.outlines, target, from, to))
      return fmt::format(
          "give both sectors the same points there: the vertex ({}, {}) misses "
          "({}, {}) by {:.2g} m",
          missed->vertex.x, missed->vertex.y, missed->point.x, missed->point.y, missed->distance);
    return "give both sectors the same points there, to within 1 mm";
  }

  /// Whether the two ends of what is left of a wall were hardly meant to be two.
  static bool isSliver(const Segment& segment, double wall) {
    constexpr double kLongest = 0.25;  // metres
    return length(segment.p1 - segment.p0) < std::min(kLongest, wall / 2);
  }

  /// A segment of `sector` that `target` leads back to, and that leads nowhere itself.
  std::optional<SegmentId> ledBackTo(SectorId sector, SectorId target) const {
    for (const Segment& leading : linking_.level.segmentsOf(linking_.level[target])) {
      if (!std::ranges::binary_search(targetsOf(leading.wall), sector)) continue;
      const std::optional<SegmentId> led = twins_.find(leading, sector);
      if (led && targetsOf(linking_.level[*led].wall).empty()) return led;
    }
    return std::nullopt;
  }

  Linking& linking_;
  TwinIndex twins_;
  WallsBehind behind_;
  std::set<std::pair<const WallDescription*, SectorId>> reported_;
};

}  // namespace

void linkSegments(Linking& linking) {
  Welder welder(linking.outlines);
  for (const Touch& touch : linking.outlines.touches) welder.addTouch(touch);
  EdgePairer pairer(linking, welder);
  pairer.pairPortals();
  pairer.pairFlatPortals();
  const Weld weld = welder.finish();

  std::vector<Vec2>& points = linking.outlines.points;
  // A representative is the first of its group, so its own coordinates do not change.
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = points[weld.representative[i]];
  SegmentBuilder builder(linking, weld);
  for (std::uint32_t i = 0; i < linking.outlines.sectors.size(); ++i) builder.buildSector(i);
  TwinChecker(linking).check();
}

}  // namespace hearth
