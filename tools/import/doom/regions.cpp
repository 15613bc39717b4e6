#include "import/doom/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "math/check.h"
#include "math/predicates.h"

namespace hearth::doom {

namespace {

using HalfEdgeId = std::uint32_t;
using Loop = std::vector<HalfEdgeId>;

constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();

HalfEdgeId twin(HalfEdgeId h) { return Regions::twinOf(h); }

/// Divides the plane along pieces. Half-edge 2i goes along piece i, 2i + 1 back.
class Subdivision {
 public:
  explicit Subdivision(const Pieces& pieces)
      : pieces_(pieces), isThere_(pieces.pieces.size(), true) {
    divide();
  }

  std::size_t halfEdges() const { return 2 * pieces_.pieces.size(); }
  bool has(HalfEdgeId h) const { return isThere_[h / 2]; }
  std::uint32_t fromPoint(HalfEdgeId h) const { return pieces_.pieces[h / 2].points[h % 2]; }
  Vec2 from(HalfEdgeId h) const { return pieces_.points[fromPoint(h)]; }
  Vec2 to(HalfEdgeId h) const { return from(twin(h)); }
  const std::optional<Face>& face(HalfEdgeId h) const { return pieces_.pieces[h / 2].faces[h % 2]; }
  /// Which cell the half-edge bounds; none for what lies outside of all.
  std::optional<std::uint32_t> cell(HalfEdgeId h) const {
    const std::uint32_t cell = cellOfContour_[contour_[h]];
    return cell == kNoNode ? std::nullopt : std::optional(cell);
  }
  std::size_t cells() const { return cells_; }
  const std::vector<Loop>& contours() const { return contours_; }

  void remove(const std::vector<std::uint32_t>& pieces) {
    for (const std::uint32_t piece : pieces) isThere_[piece] = false;
    divide();
  }

 private:
  void divide() {
    linkNext();
    traceContours();
    findCells();
  }

  /// After a half-edge comes the one that bounds the same wedge of space at its end.
  void linkNext() {
    std::vector<std::vector<HalfEdgeId>> leaving(pieces_.points.size());
    for (HalfEdgeId h = 0; h < halfEdges(); ++h)
      if (has(h)) leaving[fromPoint(h)].push_back(h);
    next_.assign(halfEdges(), kNoNode);
    for (auto& around : leaving) {
      std::ranges::sort(around, [this](HalfEdgeId a, HalfEdgeId b) { return turnsLess(a, b); });
      for (std::size_t i = 0; i < around.size(); ++i)
        next_[twin(around[i])] = around[(i + around.size() - 1) % around.size()];
    }
  }

  /// Of two half-edges that leave a point: by their angle from +x on, towards +y.
  bool turnsLess(HalfEdgeId a, HalfEdgeId b) const {
    const Vec2 u = to(a) - from(a);
    const Vec2 v = to(b) - from(b);
    const auto isInSecondHalf = [](Vec2 d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
    if (isInSecondHalf(u) != isInSecondHalf(v)) return isInSecondHalf(v);
    return cross(u, v) > 0;
  }

  void traceContours() {
    contours_.clear();
    contour_.assign(halfEdges(), kNoNode);
    for (HalfEdgeId first = 0; first < halfEdges(); ++first) {
      if (!has(first) || contour_[first] != kNoNode) continue;
      Loop& loop = contours_.emplace_back();
      for (HalfEdgeId h = first; contour_[h] == kNoNode; h = next_[h]) {
        contour_[h] = static_cast<std::uint32_t>(contours_.size() - 1);
        loop.push_back(h);
      }
    }
  }

  /// A contour round which space lies begins a cell; the others, which are the outer sides of what
  /// hangs together, lie in the cell around.
  void findCells() {
    cells_ = 0;
    cellOfContour_.assign(contours_.size(), kNoNode);
    std::vector<std::uint32_t> outer;
    for (std::uint32_t i = 0; i < contours_.size(); ++i)
      if (area(contours_[i]) > 0)
        cellOfContour_[i] = static_cast<std::uint32_t>(cells_++);
      else
        outer.push_back(i);
    // From left to right, so that what lies to the left has its cell already.
    std::ranges::sort(outer, lessXY, [this](std::uint32_t i) { return leftmost(contours_[i]); });
    for (const std::uint32_t i : outer) {
      const auto left = halfEdgeLeftOf(leftmost(contours_[i]));
      if (left) cellOfContour_[i] = cellOfContour_[contour_[*left]];
    }
  }

  double area(const Loop& loop) const {
    const Vec2 origin = from(loop.front());
    double sum = 0;
    for (const HalfEdgeId h : loop) sum += cross(from(h) - origin, to(h) - origin);
    return sum / 2;
  }

  Vec2 leftmost(const Loop& loop) const {
    Vec2 least = from(loop.front());
    for (const HalfEdgeId h : loop) least = lessXY(from(h), least) ? from(h) : least;
    return least;
  }

  /// The half-edge that is met first from a point towards -x, in front of it: of those that cross
  /// the line that lies by nothing below the point.
  std::optional<HalfEdgeId> halfEdgeLeftOf(Vec2 p) const {
    std::optional<HalfEdgeId> nearest;
    for (HalfEdgeId h = 0; h < halfEdges(); ++h) {
      // From below to above on the map (y down), so that its front is to the right.
      if (!has(h) || !(to(h).y <= p.y && p.y < from(h).y)) continue;
      if (orientation(from(h), to(h), p) <= 0) continue;
      if (!nearest || isRightOf(h, *nearest)) nearest = h;
    }
    return nearest;
  }

  /// Of two half-edges that go up and cross one line but not each other.
  bool isRightOf(HalfEdgeId a, HalfEdgeId b) const {
    const int fromA = orientation(from(b), to(b), from(a));
    const int toA = orientation(from(b), to(b), to(a));
    if (fromA >= 0 && toA >= 0) return fromA + toA > 0;
    if (fromA <= 0 && toA <= 0) return false;
    return orientation(from(a), to(a), from(b)) <= 0 && orientation(from(a), to(a), to(b)) <= 0;
  }

  const Pieces& pieces_;
  std::vector<bool> isThere_;
  std::vector<HalfEdgeId> next_;
  std::vector<Loop> contours_;
  std::vector<std::uint32_t> contour_;        ///< by half-edge
  std::vector<std::uint32_t> cellOfContour_;  ///< kNoNode: outside of all
  std::size_t cells_ = 0;
};

class RegionFinder {
 public:
  RegionFinder(const Map& map, const std::set<std::uint32_t>& starters, const Pieces& pieces,
               Findings& findings)
      : map_(map), starters_(starters), findings_(findings), plane_(pieces) {}

  Regions find() {
    do {
      chooseSectors();
    } while (removeWhatDividesNothing());
    tellOfStrayedSides();
    return regions();
  }

 private:
  std::optional<std::uint32_t> namedSector(HalfEdgeId h) const {
    const auto& face = plane_.face(h);
    return face ? std::optional(map_.sides[face->side].sector) : std::nullopt;
  }

  /// By cell: the sector that the greatest part of its outline names.
  void chooseSectors() {
    std::vector<std::map<std::uint32_t, double>> votes(plane_.cells());
    for (HalfEdgeId h = 0; h < plane_.halfEdges(); ++h) {
      if (!plane_.has(h) || !plane_.cell(h)) continue;
      if (const auto sector = namedSector(h))
        votes[*plane_.cell(h)][*sector] += length(plane_.to(h) - plane_.from(h));
    }
    sectors_.assign(plane_.cells(), std::nullopt);
    for (std::size_t cell = 0; cell < votes.size(); ++cell) {
      double most = 0;
      for (const auto& [sector, metres] : votes[cell])
        if (metres > most) {
          most = metres;
          sectors_[cell] = sector;
        }
    }
  }

  std::optional<std::uint32_t> sectorBefore(HalfEdgeId h) const {
    const auto cell = plane_.cell(h);
    return cell ? sectors_[*cell] : std::nullopt;
  }

  bool removeWhatDividesNothing() {
    std::vector<std::uint32_t> removed;
    for (HalfEdgeId h = 0; h < plane_.halfEdges(); h += 2)
      if (plane_.has(h) && dividesNothing(h)) removed.push_back(h / 2);
    if (!removed.empty()) plane_.remove(removed);
    return !removed.empty();
  }

  bool dividesNothing(HalfEdgeId h) {
    if (plane_.cell(h) == plane_.cell(twin(h))) {
      tellOfBridge(h);
      return true;
    }
    const auto sector = sectorBefore(h);
    if (sector != sectorBefore(twin(h))) return false;
    if (!sector) return true;  // both are rock
    // Parts of one sector, cut by a line of which both sides say so and on which nothing hangs.
    return namedSector(h) == sector && namedSector(twin(h)) == sector && !isNeeded(h) &&
           !isNeeded(twin(h));
  }

  bool isNeeded(HalfEdgeId h) const {
    const auto& face = plane_.face(h);
    return hasMaskedMiddle(h) || (face && starters_.contains(face->line));
  }

  bool hasMaskedMiddle(HalfEdgeId h) const {
    const auto& face = plane_.face(h);
    return face && map_.sides[face->side].middle != kNoTexture;
  }

  void tellOfBridge(HalfEdgeId h) {
    const auto& face = plane_.face(h) ? plane_.face(h) : plane_.face(twin(h));
    if (!face || namedSector(h) == namedSector(twin(h))) return;
    if (toldOfLines_.insert(face->line).second)
      findings_.push_back(
          {Outcome::Dropped, Part::Line, face->line, "the same space lies on both of its sides"});
  }

  /// Sides that say something else of the space before them than most of its outline does.
  void tellOfStrayedSides() {
    for (HalfEdgeId h = 0; h < plane_.halfEdges(); ++h) {
      if (!plane_.has(h) || !plane_.face(h) || namedSector(h) == sectorBefore(h)) continue;
      const std::uint32_t line = plane_.face(h)->line;
      if (!toldOfLines_.insert(line).second) continue;
      const auto sector = sectorBefore(h);
      findings_.push_back(
          {Outcome::Repaired, Part::Line, line,
           sector ? fmt::format("a side says sector {}, but lies in sector {}", *namedSector(h),
                                *sector)
                  : fmt::format("a side says sector {}, which is not closed there: it is solid",
                                *namedSector(h))});
    }
  }

  Regions regions() const {
    Regions result;
    std::vector<std::size_t> cells(plane_.cells());
    std::iota(cells.begin(), cells.end(), 0);
    std::ranges::stable_sort(cells, {}, [this](std::size_t cell) { return sectors_[cell]; });
    std::vector<std::optional<std::uint32_t>> ofCell(plane_.cells());
    for (const std::size_t cell : cells) {
      if (!sectors_[cell]) continue;
      ofCell[cell] = static_cast<std::uint32_t>(result.regions.size());
      result.regions.push_back({*sectors_[cell], {}});
    }
    for (HalfEdgeId h = 0; h < plane_.halfEdges(); ++h) {
      const auto cell = plane_.has(h) ? plane_.cell(h) : std::nullopt;
      result.halfEdges.push_back(
          {plane_.from(h), plane_.to(h), plane_.face(h), cell ? ofCell[*cell] : std::nullopt});
    }
    for (const Loop& contour : plane_.contours())
      if (const auto region = result.halfEdges[contour.front()].region)
        addLoops(contour, result.regions[*region]);
    return result;
  }

  /// A contour in parts that come to no point twice. The one round which the region lies goes
  /// first.
  void addLoops(const Loop& contour, Region& region) const {
    Loop path;
    std::map<std::uint32_t, std::size_t> at;  // where on the way a point was left
    for (const HalfEdgeId h : contour) {
      at[plane_.fromPoint(h)] = path.size();
      path.push_back(h);
      const auto met = at.find(plane_.fromPoint(twin(h)));
      if (met == at.end()) continue;
      const auto begin = path.begin() + static_cast<std::ptrdiff_t>(met->second);
      addLoop(Loop(begin, path.end()), region);
      for (auto i = begin; i != path.end(); ++i) at.erase(plane_.fromPoint(*i));
      path.erase(begin, path.end());
    }
    CHECK(path.empty(), path.size());
  }

  void addLoop(Loop loop, Region& region) const {
    double area = 0;
    for (const HalfEdgeId h : loop)
      area += cross(plane_.from(h) - plane_.from(loop[0]), plane_.to(h) - plane_.from(loop[0]));
    region.loops.insert(area > 0 ? region.loops.begin() : region.loops.end(), std::move(loop));
  }

  const Map& map_;
  const std::set<std::uint32_t>& starters_;
  Findings& findings_;
  Subdivision plane_;
  std::vector<std::optional<std::uint32_t>> sectors_;  ///< by cell
  std::set<std::uint32_t> toldOfLines_;
};

}  // namespace

std::optional<std::uint32_t> Regions::regionAt(Vec2 p) const {
  for (std::uint32_t region = 0; region < regions.size(); ++region)
    if (contains(region, p)) return region;
  return std::nullopt;
}

/// By how many half-edges lie between the point and -x. Exact, and the same of both half-edges of a
/// line, so that regions neither overlap nor leave gaps.
bool Regions::contains(std::uint32_t region, Vec2 p) const {
  bool isInside = false;
  for (const auto& loop : regions[region].loops)
    for (const std::uint32_t i : loop) {
      const HalfEdge& h = halfEdges[i];
      if ((h.from.y <= p.y) == (h.to.y <= p.y)) continue;
      const bool isDown = h.from.y < h.to.y;
      if (orientation(isDown ? h.from : h.to, isDown ? h.to : h.from, p) <= 0) isInside = !isInside;
    }
  return isInside;
}

bool Regions::isPortal(std::uint32_t halfEdge) const {
  const auto isTwoSided = [](const HalfEdge& side) { return side.face && side.face->isTwoSided; };
  const HalfEdge& behind = halfEdges[twinOf(halfEdge)];
  return behind.region && (isTwoSided(halfEdges[halfEdge]) || isTwoSided(behind));
}

tl::expected<Regions, std::string> findRegions(const Map& map,
                                               const std::set<std::uint32_t>& starters,
                                               Findings& findings) {
  const auto pieces = piecesOf(map, starters, findings);
  if (!pieces) return tl::unexpected(pieces.error());
  return RegionFinder(map, starters, *pieces, findings).find();
}

}  // namespace hearth::doom
