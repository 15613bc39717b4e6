#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Random levels with a grid, and the same levels with its sectors written out.
namespace hearth::test {

struct GridTexture {
  std::string name;
  double scale = 1;   // metres, both ways
  double offset = 0;  // texels, both ways
  double along = 0;   // metres
};

struct GridEntry {
  enum class Kind { Solid, Air, Next };

  Kind kind = Kind::Solid;
  std::string character;  // UTF-8
  std::string spelling;   // the same in JSON, perhaps escaped
  // Of solids:
  GridTexture wall;
  std::array<std::optional<GridTexture>, 4> sides;  // n, e, s, w
  // Of air:
  double floor = 0;
  double ceiling = 3;
  bool isSky = false;
  double light = 0;
  // Of air and of the hall:
  GridTexture upper;
  GridTexture lower;
};

/// With a level's other sector, the hall: the rectangle of the cells of an entry with `next`, if
/// there are any.
struct RandomGrid {
  double cell = 1;
  double x = 0;
  double y = 0;
  std::vector<GridEntry> entries;
  std::vector<std::vector<int>> cells;  // rows of indices of entries; kBlank

  static constexpr int kBlank = -1;

  int columns() const { return static_cast<int>(cells.front().size()); }
  int rows() const { return static_cast<int>(cells.size()); }
  /// Null for blanks and beyond the rows.
  const GridEntry* at(int column, int row) const;
};

RandomGrid makeRandomGrid(std::uint64_t seed);

struct GridLevel {
  std::string withGrid;
  std::string writtenOut;
  std::string lights;
};
/// Both files have the same shots, which look around in some of the cells.
GridLevel gridLevel(const RandomGrid& grid, std::uint64_t seed);

}  // namespace hearth::test
