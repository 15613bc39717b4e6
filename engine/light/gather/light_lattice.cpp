#include "light/gather/light_lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hearth {

namespace {

int middle(int from, int to) { return from + (to - from) / 2; }

/// Multiples of a cell's side between two ends, and the ends: none so near to an end that a cell
/// would be narrow. A single line is both ends of cells without width.
std::vector<int> linesBetween(int from, int to, const LightLattice::Cells& cells) {
  if (to - from < cells.narrow) return {middle(from, to), middle(from, to)};
  std::vector<int> lines{from};
  const int first =
      static_cast<int>(std::floor(static_cast<double>(from) / cells.side)) * cells.side;
  for (int line = first; line < to; line += cells.side)
    if (4 * (line - from) >= cells.side && 4 * (to - line) >= cells.side && line > from)
      lines.push_back(line);
  lines.push_back(to);
  return lines;
}

std::size_t placeIn(const std::vector<int>& lines, double x) {
  const auto after = std::upper_bound(lines.begin() + 1, lines.end() - 1, x);
  return static_cast<std::size_t>(after - lines.begin()) - 1;
}

/// Counted in middles of texels, no farther out than those of `count` texels. A sample in the
/// middle of a texel is on a line between cells, and rounding must not choose which of them tells
/// its light.
double fromMiddle(double texels, int first, int count) {
  constexpr double kRounding = 1e-6;
  const double x = std::clamp<double>(texels - 0.5, first, first + count - 1);
  const double nearest = std::round(x);
  return std::abs(x - nearest) < kRounding ? nearest : x;
}

double fractionOf(double x, int from, int to) {
  return to > from ? std::clamp((x - from) / (to - from), 0.0, 1.0) : 0;
}

Vec2 fractionOf(Vec2 p, const std::array<int, 2>& from, const std::array<int, 2>& to) {
  return {fractionOf(p.x, from[0], to[0]), fractionOf(p.y, from[1], to[1])};
}

}  // namespace

LightLattice::LightLattice(const TexelRect& texels, const Cells& cells,
                           std::vector<double> tolerances, ValuesAt valuesAt)
    : texels_(texels),
      tolerances_(std::move(tolerances)),
      areDivided_(cells.areDivided),
      valuesAt_(std::move(valuesAt)),
      columns_(linesBetween(texels.i0, texels.i0 + texels.width - 1, cells)),
      rows_(linesBetween(texels.j0, texels.j0 + texels.height - 1, cells)) {
  for (std::size_t row = 0; row + 1 < rows_.size(); ++row)
    for (std::size_t column = 0; column + 1 < columns_.size(); ++column)
      cells_.push_back({{columns_[column], rows_[row]}, {columns_[column + 1], rows_[row + 1]}});
}

double LightLattice::at(Vec2 p, std::size_t value) {
  const double x = fromMiddle(p.x, texels_.i0, texels_.width);
  const double y = fromMiddle(p.y, texels_.j0, texels_.height);
  auto index =
      static_cast<std::uint32_t>(placeIn(rows_, y) * (columns_.size() - 1) + placeIn(columns_, x));
  while (true) {
    if (!cells_[index].isDecided) decide(index);
    const Cell& cell = cells_[index];
    const std::array<int, 2>& from = cell.from;
    const std::array<int, 2>& to = cell.to;
    if (cell.firstPart == 0) return interpolated(cell.corners, fractionOf({x, y}, from, to), value);
    const int right = x >= middle(from[0], to[0]) && to[0] - from[0] > 1 ? 1 : 0;
    const int low = y >= middle(from[1], to[1]) && to[1] - from[1] > 1 ? 2 : 0;
    index = cell.firstPart + static_cast<std::uint32_t>(right + low);
  }
}

LightLattice::Node LightLattice::nodeAt(int i, int j) {
  const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(i)} << 32 |
                            std::uint64_t{static_cast<std::uint32_t>(j)};
  const auto [entry, isNew] = nodes_.try_emplace(key, static_cast<Node>(isThere_.size()));
  if (isNew) {
    const std::size_t count = tolerances_.size();
    values_.resize(values_.size() + count);
    isThere_.push_back(valuesAt_(i, j, std::span(values_).last(count)));
  }
  return entry->second;
}

std::span<const double> LightLattice::valuesOf(Node node) const {
  const std::size_t count = tolerances_.size();
  return std::span(values_).subspan(node * count, count);
}

std::array<LightLattice::Node, 4> LightLattice::cornersOf(const Cell& cell) {
  const auto [from, to] = std::pair(cell.from, cell.to);
  return {nodeAt(from[0], from[1]), nodeAt(to[0], from[1]), nodeAt(from[0], to[1]),
          nodeAt(to[0], to[1])};
}

/// Whether a cell is divided. Where its corners describe what is between them its parts are not
/// divided any more: they know of these points, too.
void LightLattice::decide(std::uint32_t index) {
  const Cell cell = cells_[index];
  cells_[index].isDecided = true;
  const std::array<Node, 4> corners = cornersOf(cell);
  cells_[index].corners = corners;
  const std::array<int, 2> from = cell.from;
  const std::array<int, 2> to = cell.to;
  const int side = std::max(to[0] - from[0], to[1] - from[1]);
  if (!areDivided_ || side <= 1) return;
  const std::array<int, 3> columns{from[0], middle(from[0], to[0]), to[0]};
  const std::array<int, 3> rows{from[1], middle(from[1], to[1]), to[1]};
  const auto isDescribed = [&](int i, int j) {
    return describes(corners, fractionOf({1.0 * i, 1.0 * j}, from, to), nodeAt(i, j));
  };
  if (!isDescribed(columns[1], rows[1])) return divide(index, false);
  // In a cell of few texels no more is asked.
  constexpr int kFew = 2;
  if (side <= kFew) return;
  bool areDescribed = true;
  for (const int j : rows)
    for (const int i : columns) areDescribed = areDescribed && isDescribed(i, j);
  divide(index, areDescribed);
}

void LightLattice::divide(std::uint32_t index, bool areDecided) {
  const auto firstPart = static_cast<std::uint32_t>(cells_.size());
  cells_[index].firstPart = firstPart;
  const std::array<int, 2> from = cells_[index].from;
  const std::array<int, 2> to = cells_[index].to;
  const bool isWide = to[0] - from[0] > 1;
  const bool isHigh = to[1] - from[1] > 1;
  const int i = isWide ? middle(from[0], to[0]) : to[0];
  const int j = isHigh ? middle(from[1], to[1]) : to[1];
  // A part to the right or below of what is one texel wide or high is never asked for.
  cells_.push_back({from, {i, j}});
  cells_.push_back({{i, from[1]}, {to[0], j}});
  cells_.push_back({{from[0], j}, {i, to[1]}});
  cells_.push_back({{i, j}, to});
  if (!areDecided) return;
  for (std::uint32_t part = firstPart; part < firstPart + 4; ++part) {
    const std::array<Node, 4> corners = cornersOf(cells_[part]);
    cells_[part].corners = corners;
    cells_[part].isDecided = true;
  }
}

/// Light beyond full brightness, 255 levels, need not be known to a level.
double LightLattice::toleranceAt(double value, std::size_t index) const {
  return std::max(tolerances_[index], std::abs(value) / 255);
}

/// Whether the corners have values, and a node between them those that are interpolated.
bool LightLattice::describes(const std::array<Node, 4>& corners, Vec2 fraction, Node node) const {
  if (!isThere(node) ||
      !std::ranges::all_of(corners, [this](Node corner) { return isThere(corner); }))
    return false;
  const std::span<const double> values = valuesOf(node);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(interpolated(corners, fraction, i) - values[i]) > toleranceAt(values[i], i))
      return false;
  return true;
}

/// Corners without values do not count.
double LightLattice::interpolated(const std::array<Node, 4>& corners, Vec2 fraction,
                                  std::size_t value) const {
  const std::array<double, 4> weights{(1 - fraction.x) * (1 - fraction.y),
                                      fraction.x * (1 - fraction.y), (1 - fraction.x) * fraction.y,
                                      fraction.x * fraction.y};
  double sum = 0;
  double all = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (!isThere(corners[k])) continue;
    sum += weights[k] * valuesOf(corners[k])[value];
    all += weights[k];
  }
  return all > 0 ? sum / all : 0;
}

}  // namespace hearth
