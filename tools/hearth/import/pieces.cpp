#include "hearth/import/pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "math/predicates.h"

namespace hearth::doom {

namespace {

/// Metres, a power of two: places at which lines cross are rounded to multiples of it, so that
/// areas are computed exactly from them, too. An eighth of a millimetre.
constexpr double kGrid = 1.0 / 8192;

/// Places at which lines are cut, at most: without a bound a small hostile map would fill the
/// memory. All maps of Freedoom together have eight.
constexpr std::size_t kMostCuts = 100'000;

Vec2 onGrid(Vec2 p) { return {std::round(p.x / kGrid) * kGrid, std::round(p.y / kGrid) * kGrid}; }

/// A line with the places at which it is to be cut.
struct Cuttable {
  Vec2 from;
  Vec2 to;
  std::uint32_t line;
  std::vector<Vec2> cuts;

  double minX() const { return std::min(from.x, to.x); }
  double maxX() const { return std::max(from.x, to.x); }
  bool overlapsInY(const Cuttable& other) const {
    return std::min(from.y, to.y) <= std::max(other.from.y, other.to.y) &&
           std::min(other.from.y, other.to.y) <= std::max(from.y, to.y);
  }
  /// Of a point that is in line with it.
  bool hasWithin(Vec2 p) const {
    const double t = dot(p - from, to - from);
    return t > 0 && t < dot(to - from, to - from);
  }
};

class Cutter {
 public:
  Cutter(const Map& map, Findings& findings) : map_(map), findings_(findings) {}

  Pieces cut() {
    gather();
    meetAll();
    for (Cuttable& line : lines_) addPieces(line);
    return std::move(result_);
  }

 private:
  void gather() {
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      const Vertex& a = map_.vertices[map_.lines[i].from];
      const Vertex& b = map_.vertices[map_.lines[i].to];
      if (a.x == b.x && a.y == b.y)
        findings_.push_back({Outcome::Dropped, Part::Line, i, "it has no length"});
      else
        lines_.push_back({placeOf(a.x, a.y), placeOf(b.x, b.y), static_cast<std::uint32_t>(i), {}});
    }
  }

  void meetAll() {
    std::ranges::sort(lines_, {}, [](const Cuttable& c) { return std::pair(c.minX(), c.line); });
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t j = i + 1; j < lines_.size() && lines_[j].minX() <= lines_[i].maxX(); ++j) {
        if (lines_[i].overlapsInY(lines_[j])) meet(lines_[i], lines_[j]);
        if (cuts_ < kMostCuts) continue;
        findings_.push_back({Outcome::Dropped, Part::Line, lines_[i].line,
                             fmt::format("lines have met in {} places before it and the next ones: "
                                         "where these meet is not looked for",
                                         cuts_)});
        return;
      }
  }

  void meet(Cuttable& a, Cuttable& b) {
    const int from = orientation(a.from, a.to, b.from);
    const int to = orientation(a.from, a.to, b.to);
    const int aFrom = orientation(b.from, b.to, a.from);
    const int aTo = orientation(b.from, b.to, a.to);
    if (from == 0 && a.hasWithin(b.from)) cutAt(a, b.from);
    if (to == 0 && a.hasWithin(b.to)) cutAt(a, b.to);
    if (aFrom == 0 && b.hasWithin(a.from)) cutAt(b, a.from);
    if (aTo == 0 && b.hasWithin(a.to)) cutAt(b, a.to);
    if (from * to >= 0 || aFrom * aTo >= 0) return;
    const double c = cross(b.to - b.from, a.from - b.from);
    const double d = cross(b.to - b.from, a.to - b.from);
    const Vec2 p = onGrid(lerp(a.from, a.to, c / (c - d)));
    cutAt(a, p);
    cutAt(b, p);
    findings_.push_back({Outcome::Repaired, Part::Line, std::max(a.line, b.line),
                         fmt::format("it crosses line {} at ({:g}, {:g}): both are cut there",
                                     std::min(a.line, b.line), p.x / kUnit, -p.y / kUnit)});
  }

  void cutAt(Cuttable& line, Vec2 p) {
    line.cuts.push_back(p);
    ++cuts_;
  }

  void addPieces(Cuttable& line) {
    const Vec2 direction = line.to - line.from;
    line.cuts.push_back(line.from);
    line.cuts.push_back(line.to);
    std::ranges::sort(line.cuts, {}, [&](Vec2 p) { return dot(p - line.from, direction); });
    for (std::size_t i = 0; i + 1 < line.cuts.size(); ++i)
      if (line.cuts[i] != line.cuts[i + 1]) addPiece(line, line.cuts[i], line.cuts[i + 1]);
  }

  void addPiece(const Cuttable& line, Vec2 from, Vec2 to) {
    const Line& of = map_.lines[line.line];
    const std::array<double, 2> along{length(from - line.from), length(line.to - to)};
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
  Findings& findings_;
  std::vector<Cuttable> lines_;
  std::size_t cuts_ = 0;
  std::map<std::pair<double, double>, std::uint32_t> pointsAt_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known_;
  Pieces result_;
};

}  // namespace

Pieces piecesOf(const Map& map, Findings& findings) { return Cutter(map, findings).cut(); }

}  // namespace hearth::doom
