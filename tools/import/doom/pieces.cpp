#include "import/doom/pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "import/doom/snap_rounding.h"
#include "math/predicates.h"

namespace hearth::doom {

namespace {

/// Cells of the grid of points in a unit of a map, a power of two, so that areas are computed
/// exactly from them. Half a cell is 4 mm: loops whose points are twice the loader's tolerance of 1
/// mm off the walls that they do not end are sound to it, and enclose area.
constexpr int kCells = 4;
constexpr double kCell = kUnit / kCells;

/// Without a bound a small hostile map would fill the memory, and a level of as many walls would
/// not load. All maps of Freedoom together have four crossings, the largest one 17,000 walls.
constexpr std::size_t kMaxCrossings = 50'000;
constexpr std::size_t kMaxPieces = 250'000;

GridPoint gridPointOf(const Vertex& vertex) { return {vertex.x * kCells, -vertex.y * kCells}; }
Vec2 metresOf(GridPoint p) { return {p.x * kCell, p.y * kCell}; }
std::string nameOf(GridPoint p) {
  return fmt::format("({:g}, {:g})", double{1} * p.x / kCells, double{-1} * p.y / kCells);
}

/// A line with the places at which others cross it.
struct Cuttable {
  GridPoint from;
  GridPoint to;
  std::uint32_t line;
  std::vector<GridPoint> crossings{};
  bool isAdded = false;  ///< a side of a sliver

  int minX() const { return std::min(from.x, to.x); }
  int maxX() const { return std::max(from.x, to.x); }
  bool overlapsInY(const Cuttable& other) const {
    return std::min(from.y, to.y) <= std::max(other.from.y, other.to.y) &&
           std::min(other.from.y, other.to.y) <= std::max(from.y, to.y);
  }
};

class Cutter {
 public:
  Cutter(const Map& map, const std::set<std::uint32_t>& starters, Findings& findings)
      : map_(map), starters_(starters), findings_(findings) {}

  tl::expected<Pieces, std::string> cut() {
    gather();
    if (!findCrossings())
      return tl::unexpected(
          fmt::format("its lines cross in more than {} places: too many to cut "
                      "them there",
                      kMaxCrossings));
    const SnapRounding rounding(hotPoints());
    std::size_t pieces = 0;  // before those in one place become one
    for (const Cuttable& line : lines_) {
      const std::vector<GridPoint> path = rounding.pathOf(line.from, line.to);
      pieces += path.size() - 1;
      if (pieces > kMaxPieces)
        return tl::unexpected(
            fmt::format("its lines meet so often that they would have to be cut "
                        "into more than {} pieces",
                        kMaxPieces));
      addPieces(line, path);
    }
    return std::move(result_);
  }

 private:
  void gather() {
    countEnds();
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      const GridPoint from = gridPointOf(map_.vertices[map_.lines[i].from]);
      const GridPoint to = gridPointOf(map_.vertices[map_.lines[i].to]);
      if (from == to)
        findings_.push_back({Outcome::Dropped, Part::Line, i, "it has no length"});
      else
        add({from, to, static_cast<std::uint32_t>(i)});
    }
  }

  void countEnds() {
    for (const Line& line : map_.lines)
      for (const std::uint32_t vertex : {line.from, line.to})
        ++endsAt_[{map_.vertices[vertex].x, map_.vertices[vertex].y}];
  }

  void add(const Cuttable& line) {
    lines_.push_back(line);
    if (!startsAndEndsInside(map_.lines[line.line], line.line)) return;
    const double scale = kCells / std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
    const auto moved = [&](GridPoint p) {
      return GridPoint{p.x + static_cast<int>(std::lround((line.from.y - line.to.y) * scale)),
                       p.y + static_cast<int>(std::lround((line.to.x - line.from.x) * scale))};
    };
    const GridPoint from = moved(line.from);
    const GridPoint to = moved(line.to);
    for (const auto& [a, b] :
         {std::pair(from, to), std::pair(line.from, from), std::pair(line.to, to)})
      lines_.push_back({a, b, line.line, {}, true});
  }

  /// A line that starts something, and ends within a sector: it divides nothing, so nobody would
  /// cross it. It becomes the side of a sliver, a unit wide.
  bool startsAndEndsInside(const Line& line, std::uint32_t number) const {
    if (!starters_.contains(number) || !line.sides[0] || !line.sides[1]) return false;
    const Side& right = map_.sides[*line.sides[0]];
    const Side& left = map_.sides[*line.sides[1]];
    if (right.sector != left.sector || right.middle != kNoTexture || left.middle != kNoTexture)
      return false;
    const auto endsAlone = [this](std::uint32_t vertex) {
      return endsAt_.at({map_.vertices[vertex].x, map_.vertices[vertex].y}) == 1;
    };
    return endsAlone(line.from) || endsAlone(line.to);
  }

  /// False where there are too many.
  bool findCrossings() {
    std::ranges::sort(lines_, {}, [](const Cuttable& c) { return std::pair(c.minX(), c.line); });
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t j = i + 1; j < lines_.size() && lines_[j].minX() <= lines_[i].maxX(); ++j) {
        if (lines_[i].overlapsInY(lines_[j])) cross(lines_[i], lines_[j]);
        if (crossings_ > kMaxCrossings) return false;
      }
    return true;
  }

  void cross(Cuttable& a, Cuttable& b) {
    const auto p = crossingOf(a.from, a.to, b.from, b.to);
    if (!p) return;
    ++crossings_;
    a.crossings.push_back(*p);
    b.crossings.push_back(*p);
    if (a.isAdded || b.isAdded) return;
    findings_.push_back({Outcome::Repaired, Part::Line, std::max(a.line, b.line),
                         fmt::format("it crosses line {} at {}: both are cut there",
                                     std::min(a.line, b.line), nameOf(*p))});
  }

  std::vector<GridPoint> hotPoints() const {
    std::vector<GridPoint> hot;
    for (const Cuttable& line : lines_) {
      hot.push_back(line.from);
      hot.push_back(line.to);
      hot.insert(hot.end(), line.crossings.begin(), line.crossings.end());
    }
    return hot;
  }

  void addPieces(const Cuttable& line, const std::vector<GridPoint>& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (i > 0) tellOfBend(line, path[i]);
      addPiece(line, metresOf(path[i]), metresOf(path[i + 1]));
    }
  }

  void tellOfBend(const Cuttable& line, GridPoint at) {
    if (line.isAdded || orientation(metresOf(line.from), metresOf(line.to), metresOf(at)) == 0)
      return;
    if (std::ranges::find(line.crossings, at) != line.crossings.end()) return;  // told
    findings_.push_back({Outcome::Repaired, Part::Line, line.line,
                         fmt::format("it all but touches {}, where another line ends: it is bent "
                                     "to it",
                                     nameOf(at))});
  }

  void addPiece(const Cuttable& line, Vec2 from, Vec2 to) {
    const Line& of = map_.lines[line.line];
    const std::array<double, 2> along{length(from - metresOf(line.from)),
                                      length(metresOf(line.to) - to)};
    Piece piece{{pointAt(from), pointAt(to)}, {}};
    for (const std::size_t i : {0U, 1U})
      if (of.sides[i])
        piece.faces[i] = Face{*of.sides[i], line.line, along[i], of.sides[0] && of.sides[1]};
    const auto [min, max] = std::minmax(piece.points[0], piece.points[1]);
    const auto [found, isNew] = known_.try_emplace({min, max}, result_.pieces.size());
    if (isNew)
      result_.pieces.push_back(piece);
    else
      merge(result_.pieces[found->second], piece, line.line);
  }

  /// Of two lines between the same points each side is the one of the first that has it.
  void merge(Piece& kept, const Piece& other, std::uint32_t line) {
    const bool isTurned = kept.points[0] != other.points[0];
    for (const std::size_t i : {0U, 1U})
      if (!kept.faces[i]) kept.faces[i] = other.faces[isTurned ? 1 - i : i];
    findings_.push_back({Outcome::Repaired, Part::Line, line,
                         "another line lies in the same place: the first one's sides are taken"});
  }

  std::uint32_t pointAt(Vec2 p) {
    const auto [found, isNew] =
        pointsAt_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(result_.points.size()));
    if (isNew) result_.points.push_back(p);
    return found->second;
  }

  const Map& map_;
  const std::set<std::uint32_t>& starters_;
  Findings& findings_;
  std::map<std::pair<int, int>, int> endsAt_;  ///< of lines, by place
  std::vector<Cuttable> lines_;
  std::size_t crossings_ = 0;
  std::map<std::pair<double, double>, std::uint32_t> pointsAt_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known_;
  Pieces result_;
};

}  // namespace

tl::expected<Pieces, std::string> piecesOf(const Map& map, const std::set<std::uint32_t>& starters,
                                           Findings& findings) {
  return Cutter(map, starters, findings).cut();
}

}  // namespace hearth::doom
