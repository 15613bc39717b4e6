// The sectors of a grid by another way than the loader's: labels that spread until nothing changes,
// and loops chained from single edges of cells.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "random_grid.h"
#include "random_levels/random.h"

namespace hearth::test {

namespace {

using Corner = std::pair<int, int>;  // row, column: of the least x and y first

std::string number(double value) { return fmt::format("{}", value); }

std::string textureText(const GridTexture& texture, double along) {
  return fmt::format(R"({{"name": "{}", "scale": [{}, {}], "offset": [{}, {}], "along": {}}})",
                     texture.name, number(texture.scale), number(texture.scale),
                     number(texture.offset), number(texture.offset), number(texture.along + along));
}

std::string flats(const GridEntry& air) {
  return fmt::format(
      R"("floor": {{"z": {}, "texture": "square"}}, "ceiling": {{"z": {}, "texture": "wide"{}}}, "light": {})",
      number(air.floor), number(air.ceiling), air.isSky ? R"(, "parallax": true)" : "",
      number(air.light));
}

/// What a wall keeps along its length.
struct Behind {
  int column = 0;  // of the first cell
  int row = 0;
  const GridEntry* entry = nullptr;
  int label = -1;  // of air
};

struct CellEdge {
  Corner from;
  Corner to;
  Behind behind;

  Corner step() const { return {to.first - from.first, to.second - from.second}; }
};

class Writer {
 public:
  explicit Writer(const RandomGrid& grid) : grid_(grid) { spreadLabels(); }

  std::string allSectors() const {
    std::string text;
    for (const int label : labels()) text += (text.empty() ? "" : ",\n") + sector(label);
    return text;
  }

  /// Empty without a hall.
  std::string hall() const {
    std::string vertices;
    std::string walls;
    const auto loops = loopsOf([&](int column, int row) { return isHall(column, row); });
    for (const CellEdge& edge : loops.front()) {
      const bool isPortal = edge.behind.label >= 0;
      vertices += (vertices.empty() ? "" : ", ") + vertex(edge.from);
      walls +=
          fmt::format(R"({}{{{}"texture": "odd"}})", walls.empty() ? "" : ", ",
                      isPortal ? fmt::format(R"("next": "{}", )", name(edge.behind.label)) : "");
    }
    return fmt::format(
        R"("hall": {{"floor": {{"z": 0.1, "texture": "odd"}}, "ceiling": {{"z": 2.2, "texture": "seven"}}, "loops": {{"border": {{"v": [{}], "walls": [{}]}}}}}})",
        vertices, walls);
  }
  bool hasHall() const { return grid_.entries.back().kind == GridEntry::Kind::Next; }

  std::string name(int label) const {
    return fmt::format("{}{},{}",
                       grid_.at(label % grid_.columns(), label / grid_.columns())->character,
                       label % grid_.columns(), label / grid_.columns());
  }
  int labelOf(int column, int row) const {
    const GridEntry* entry = grid_.at(column, row);
    if (!entry || entry->kind != GridEntry::Kind::Air) return -1;
    return labels_[static_cast<std::size_t>(row * grid_.columns() + column)];
  }

 private:
  bool isHall(int column, int row) const {
    const GridEntry* entry = grid_.at(column, row);
    return entry && entry->kind == GridEntry::Kind::Next;
  }

  /// Each cell takes the least number of its neighbours of the same entry, until nothing changes.
  void spreadLabels() {
    for (int i = 0; i < grid_.columns() * grid_.rows(); ++i) labels_.push_back(i);
    for (bool changes = true; changes;) {
      changes = false;
      for (int row = 0; row < grid_.rows(); ++row)
        for (int column = 0; column < grid_.columns(); ++column)
          for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) {
            const GridEntry* own = grid_.at(column, row);
            if (!own || grid_.at(column + dx, row + dy) != own) continue;
            int& label = labels_[static_cast<std::size_t>(row * grid_.columns() + column)];
            const int other =
                labels_[static_cast<std::size_t>((row + dy) * grid_.columns() + column + dx)];
            if (other >= label) continue;
            label = other;
            changes = true;
          }
    }
  }

  std::vector<int> labels() const {
    std::vector<int> found;
    for (int row = 0; row < grid_.rows(); ++row)
      for (int column = 0; column < grid_.columns(); ++column)
        if (const int label = labelOf(column, row); label == row * grid_.columns() + column)
          found.push_back(label);
    return found;
  }

  /// Of the cells for which `isIn`: by the corner of least y and x at which each begins.
  template <typename IsIn>
  std::vector<std::vector<CellEdge>> loopsOf(IsIn&& isIn) const {
    std::multimap<Corner, CellEdge> edges;
    const auto add = [&](Corner from, Corner to, int column, int row) {
      if (!isIn(column, row))
        edges.emplace(
            from, CellEdge{from, to, {column, row, grid_.at(column, row), labelOf(column, row)}});
    };
    for (int row = 0; row < grid_.rows(); ++row)
      for (int column = 0; column < grid_.columns(); ++column) {
        if (!isIn(column, row)) continue;
        add({row, column}, {row, column + 1}, column, row - 1);
        add({row, column + 1}, {row + 1, column + 1}, column + 1, row);
        add({row + 1, column + 1}, {row + 1, column}, column, row + 1);
        add({row + 1, column}, {row, column}, column - 1, row);
      }
    std::vector<std::vector<CellEdge>> loops;
    while (!edges.empty()) {
      std::vector<CellEdge> loop;
      for (auto next = edges.begin(); next != edges.end();) {
        loop.push_back(next->second);
        edges.erase(next);
        const auto [first, last] = edges.equal_range(loop.back().to);
        // Left of (rows, columns) is (-columns, rows): there the loop keeps to the same solid cell.
        const auto [rows, columns] = loop.back().step();
        next = first == last ? edges.end() : first;
        for (auto edge = first; edge != last; ++edge)
          if (edge->second.step() == Corner(-columns, rows)) next = edge;
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  std::string vertex(Corner corner) const {
    return fmt::format("{}, {}", number(grid_.x + grid_.cell * corner.second),
                       number(grid_.y + grid_.cell * corner.first));
  }

  std::string sector(int label) const {
    const GridEntry& air = *grid_.at(label % grid_.columns(), label / grid_.columns());
    std::string loops;
    int holes = 0;
    for (const auto& loop :
         loopsOf([&](int column, int row) { return labelOf(column, row) == label; })) {
      std::string vertices;
      std::string walls;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const CellEdge& edge = loop[i];
        if (i > 0 && loop[i - 1].step() == edge.step() &&
            loop[i - 1].behind.entry == edge.behind.entry &&
            loop[i - 1].behind.label == edge.behind.label)
          continue;
        vertices += (vertices.empty() ? "" : ", ") + vertex(edge.from);
        walls += (walls.empty() ? "" : ", ") + wall(edge, air);
      }
      loops += fmt::format(R"({}"{}": {{"v": [{}], "walls": [{}]}})", holes == 0 ? "" : ",\n  ",
                           holes == 0 ? "border" : fmt::format("hole{}", holes), vertices, walls);
      ++holes;
    }
    return fmt::format(R"("{}": {{{}, "loops": {{{}}}}})", name(label), flats(air), loops);
  }

  std::string wall(const CellEdge& edge, const GridEntry& air) const {
    const GridEntry* behind = edge.behind.entry;
    // Of a sector without height, beside which nothing shows.
    if (!behind) return R"({"texture": "#000000"})";
    if (behind->kind == GridEntry::Kind::Next)
      return fmt::format(R"({{"next": "hall", "upper": {}, "lower": {}}})",
                         textureText(behind->upper, 0), textureText(behind->lower, 0));
    if (behind->kind == GridEntry::Kind::Air)
      return fmt::format(R"({{"next": "{}", "upper": {}, "lower": {}}})", name(edge.behind.label),
                         textureText(behind->ceiling < air.ceiling ? behind->upper : air.upper, 0),
                         textureText(behind->floor > air.floor ? behind->lower : air.lower, 0));
    const auto [rows, columns] = edge.step();
    const double x = grid_.x + grid_.cell * edge.from.second;
    const double y = grid_.y + grid_.cell * edge.from.first;
    const int side = columns > 0 ? 2 : rows > 0 ? 3 : columns < 0 ? 0 : 1;
    return fmt::format(
        R"({{"texture": {}}})",
        textureText(behind->sides[static_cast<std::size_t>(side)].value_or(behind->wall),
                    (x - grid_.x) * columns + (y - grid_.y) * rows));
  }

  const RandomGrid& grid_;
  std::vector<int> labels_;
};

std::string legend(const RandomGrid& grid) {
  constexpr std::array kSides{"n", "e", "s", "w"};
  std::string text;
  for (const GridEntry& entry : grid.entries) {
    std::string body;
    if (entry.kind == GridEntry::Kind::Solid) {
      body = fmt::format(R"("wall": {}, "walls": {{)", textureText(entry.wall, 0));
      bool isFirst = true;
      for (std::size_t side = 0; side < 4; ++side)
        if (entry.sides[side]) {
          body += fmt::format(R"({}"{}": {})", isFirst ? "" : ", ", kSides[side],
                              textureText(*entry.sides[side], 0));
          isFirst = false;
        }
      body += "}";
    } else {
      body = fmt::format(R"({}, "upper": {}, "lower": {})",
                         entry.kind == GridEntry::Kind::Next ? R"("next": "hall")" : flats(entry),
                         textureText(entry.upper, 0), textureText(entry.lower, 0));
    }
    text += fmt::format(R"({}"{}": {{{}}})", text.empty() ? "" : ",\n    ", entry.spelling, body);
  }
  return text;
}

std::string gridText(const RandomGrid& grid) {
  std::string rows;
  for (const std::vector<int>& line : grid.cells) {
    rows += rows.empty() ? "\"" : ",\n    \"";
    for (const int entry : line)
      rows += entry == RandomGrid::kBlank ? " "
                                          : grid.entries[static_cast<std::size_t>(entry)].spelling;
    rows += "\"";
  }
  return fmt::format(
      R"("grid": {{"cell": {}, "origin": [{}, {}], "rows": [{}], "legend": {{{}}}}})",
      number(grid.cell), number(grid.x), number(grid.y), rows, legend(grid));
}

}  // namespace

GridLevel gridLevel(const RandomGrid& grid, std::uint64_t seed) {
  random_levels::Random random(seed);
  const Writer writer(grid);
  std::vector<std::tuple<int, int>> rooms;  // where there is space for a camera
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column)
      if (const GridEntry* entry = grid.at(column, row);
          entry && entry->kind == GridEntry::Kind::Air && entry->ceiling - entry->floor >= 1)
        rooms.emplace_back(column, row);
  const auto place = [&](double rise) {
    const auto [column, row] = random.pickFrom(rooms);
    return std::tuple(grid.x + grid.cell * (column + random.real(0.2, 0.8)),
                      grid.y + grid.cell * (row + random.real(0.2, 0.8)),
                      grid.at(column, row)->floor + rise, writer.name(writer.labelOf(column, row)));
  };
  std::string shots;
  for (int i = 0; i < 3; ++i) {
    const auto [x, y, z, sector] = place(0.6);
    shots += fmt::format(
        R"({}{{"name": "{}", "sector": "{}", "camera": [{}, {}, {}, {}, {}], "size": [64, 40]}})",
        i == 0 ? "" : ", ", i, sector, x, y, z, random.real(0, 360), random.real(-30, 30));
  }
  std::string lights;
  for (int i = 0; i < 2; ++i) {
    const auto [x, y, z, sector] = place(0.8);
    lights += fmt::format(
        R"({}{{"sector": "{}", "x": {}, "y": {}, "z": {}, "falloff": 0.3, "color": "{}"}})",
        i == 0 ? "" : ", ", sector, x, y, z, i == 0 ? "#ff8040" : "#ffffff");
  }
  const std::string head = fmt::format("{{\"light\": 0.1, \"shots\": [{}],\n", shots);
  const std::string hall = writer.hasHall() ? writer.hall() : "";
  const std::string sectors = writer.allSectors();
  const auto sectorsText = [](const std::string& text) {
    return fmt::format("\"sectors\": {{{}}}", text);
  };
  return {head + (hall.empty() ? "" : sectorsText(hall) + ",\n") + gridText(grid) + "}",
          head + sectorsText(hall + (hall.empty() ? "" : ",\n") + sectors) + "}",
          fmt::format(R"({{"bake": {{"texel": 0.25}}, "lights": [{}]}})", lights)};
}

}  // namespace hearth::test
