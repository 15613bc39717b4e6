#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "support/in_tree.h"
#include "support/level_text.h"

/// Levels of one purpose, from text.
namespace hearth::extremes {

inline const std::string kSolid = "{'texture': '#808080'}";

inline std::string portalTo(std::string_view next) {
  return fmt::format("{{'next': '{}', 'texture': '#a0a0a0'}}", next);
}

/// `sectors`: of the form of test::sectorText, with commas between.
inline std::string levelOf(std::string_view sectors, std::string_view light = "0.5") {
  return fmt::format("{{'light': {}, 'textures': '{}', 'sectors': {{{}}}}}", light,
                     test::inTree("textures").string(), sectors);
}

/// A box of air in which floor, ceiling and walls look different, with images if `textures` are
/// their names.
struct BoxRoom {
  double x0 = 0;
  double y0 = 0;
  double x1 = 8;
  double y1 = 8;
  double floor = 0;
  double ceiling = 3;
  std::string wallTexture = "'#906030'";
  std::string floorTexture = "'#303030'";
  std::string ceilingTexture = "'#e0e0ff'";

  /// `walls` in the order of the sides y0, x1, y1, x0; empty for four solid ones.
  std::string sector(std::string_view name, std::string_view walls = "") const {
    const std::string solid = fmt::format("{{'texture': {}}}", wallTexture);
    return fmt::format(
        "'{}': {{'floor': {{'z': {}, 'texture': {}}}, 'ceiling': {{'z': {}, 'texture': {}}}, "
        "'loops': {{'border': {{'v': [{},{}, {},{}, {},{}, {},{}], 'walls': {}}}}}}}",
        name, floor, floorTexture, ceiling, ceilingTexture, x0, y0, x1, y0, x1, y1, x0, y1,
        walls.empty() ? solid : std::string(walls));
  }
};

/// Rooms of a metre, `columns` x `rows`, all open to their neighbours.
inline std::string gridOfRooms(int columns, int rows) {
  const auto sideTo = [&](int x, int y) {
    return x < 0 || y < 0 || x >= columns || y >= rows ? kSolid
                                                       : portalTo(fmt::format("r{}_{}", x, y));
  };
  std::string text;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const BoxRoom room{.x0 = 1.0 * x,
                         .y0 = 1.0 * y,
                         .x1 = x + 1.0,
                         .y1 = y + 1.0,
                         .floor = 0.001 * ((7 * x + 3 * y) % 5)};
      text += (text.empty() ? "" : ",") +
              room.sector(fmt::format("r{}_{}", x, y),
                          fmt::format("[{}, {}, {}, {}]", sideTo(x, y - 1), sideTo(x + 1, y),
                                      sideTo(x, y + 1), sideTo(x - 1, y)));
    }
  return text;
}

}  // namespace hearth::extremes
