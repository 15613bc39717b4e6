#include "random_grid.h"

#include <algorithm>

#include "random_levels/random.h"

namespace hearth::test {

namespace {

using random_levels::Random;

GridTexture randomTexture(Random& random) {
  GridTexture texture{random.pick<const char*>({"odd", "seven", "square", "dot", "tall"})};
  if (random.chance(0.5)) texture.scale = random.pick({0.5, 2.0, 3.0});
  if (random.chance(0.3)) texture.offset = random.pick({1.5, -4.0});
  return texture;
}

GridEntry randomSolid(Random& random, const char* character, const char* spelling) {
  GridEntry entry;
  entry.character = character;
  entry.spelling = spelling;
  entry.wall = randomTexture(random);
  if (random.chance(0.2)) entry.wall.along = 0.75;
  for (auto& side : entry.sides)
    if (random.chance(0.3)) side = randomTexture(random);
  return entry;
}

GridEntry randomAir(Random& random, const char* character) {
  GridEntry entry;
  entry.kind = GridEntry::Kind::Air;
  entry.character = entry.spelling = character;
  entry.floor = random.pick({0.0, 0.0, 0.25, -0.5, 1.5});
  entry.ceiling = entry.floor + random.pick({0.0, 1.0, 2.0, 2.5, 3.0, 3.0});
  entry.isSky = random.chance(0.2);
  entry.light = random.pick({0.0, 0.2, 0.5});
  entry.upper = randomTexture(random);
  entry.lower = randomTexture(random);
  return entry;
}

void addHall(Random& random, RandomGrid& grid) {
  GridEntry entry;
  entry.kind = GridEntry::Kind::Next;
  entry.character = entry.spelling = "h";
  entry.upper = randomTexture(random);
  entry.lower = randomTexture(random);
  grid.entries.push_back(entry);
  const int width = static_cast<int>(random.between(1, grid.columns() - 3));
  const int height = static_cast<int>(random.between(1, grid.rows() - 2));
  const int left = static_cast<int>(random.between(1, grid.columns() - 1 - width));
  const int top = static_cast<int>(random.between(1, grid.rows() - 1 - height));
  for (int row = top; row < top + height; ++row)
    for (int column = left; column < left + width; ++column)
      grid.cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          static_cast<int>(grid.entries.size()) - 1;
}

bool isOpen(const RandomGrid& grid, int column, int row) {
  const GridEntry* entry = grid.at(column, row);
  return entry && entry->kind != GridEntry::Kind::Solid;
}

/// Makes a cell that a camera can be in.
void giveRoom(RandomGrid& grid) {
  for (int column = 1; column + 1 < grid.columns(); ++column) {
    int& entry = grid.cells[1][static_cast<std::size_t>(column)];
    if (grid.entries[static_cast<std::size_t>(entry)].kind == GridEntry::Kind::Next) continue;
    entry = 2;
    return;
  }
}

/// Solids that nothing shows become blanks, some of them.
void addBlanks(Random& random, RandomGrid& grid) {
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column)
      if (!isOpen(grid, column, row) && !isOpen(grid, column - 1, row) &&
          !isOpen(grid, column + 1, row) && !isOpen(grid, column, row - 1) &&
          !isOpen(grid, column, row + 1) && random.chance(0.5))
        grid.cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
            RandomGrid::kBlank;
}

}  // namespace

const GridEntry* RandomGrid::at(int column, int row) const {
  if (column < 0 || row < 0 || column >= columns() || row >= rows()) return nullptr;
  const int entry = cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  return entry == kBlank ? nullptr : &entries[static_cast<std::size_t>(entry)];
}

RandomGrid makeRandomGrid(std::uint64_t seed) {
  Random random(seed);
  RandomGrid grid;
  grid.cell = random.pick({1.0, 2.0, 0.7, 1.0 / 3});
  grid.x = random.pick({0.0, 0.0, -3.1, 17.0 / 7});
  grid.y = random.pick({0.0, 1.3});
  grid.entries = {randomSolid(random, "#", "#"),
                  random.chance(0.5) ? randomSolid(random, "\"", "\\\"")
                                     : randomSolid(random, "\U0001F9F1", "\\ud83e\\uDDF1"),
                  randomAir(random, "."), randomAir(random, random.chance(0.5) ? "a" : "\u00e9"),
                  randomAir(random, "b")};
  grid.entries[2].ceiling = grid.entries[2].floor + 2.5;  // room for a camera
  const double solid = random.pick({0.15, 0.4, 0.6});
  const int rows = static_cast<int>(random.between(3, 9));
  const int columns = static_cast<int>(random.between(3, 11));
  for (int row = 0; row < rows; ++row) {
    std::vector<int> line;
    for (int column = 0; column < columns; ++column) {
      const bool isEdge = row == 0 || column == 0 || row == rows - 1 || column == columns - 1;
      line.push_back(static_cast<int>(isEdge || random.chance(solid) ? random.between(0, 1)
                                                                     : random.between(2, 4)));
    }
    grid.cells.push_back(std::move(line));
  }
  if (columns > 3 && random.chance(0.4)) addHall(random, grid);
  const bool hasRoom = std::ranges::any_of(
      grid.cells, [](const std::vector<int>& line) { return std::ranges::count(line, 2) > 0; });
  if (!hasRoom) giveRoom(grid);
  addBlanks(random, grid);
  return grid;
}

}  // namespace hearth::test
