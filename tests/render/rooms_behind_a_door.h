#pragma once

#include <fmt/format.h>

#include <string>

#include "support/level_text.h"

namespace hearth::test {

/// A level of a hall, 8 m by 8 from (0, -4) on, whose east wall is a closed door, and of rooms in a
/// row behind it, open to one another.
inline std::string roomsBehindADoor(int rooms) {
  const std::string solid = "{'texture':'#808080'}";
  const auto sector = [&](const std::string& name, int west, int east, double ceiling,
                          const std::string& toWest, const std::string& toEast) {
    return sectorText(name, fmt::format("{0},-4, {1},-4, {1},4, {0},4", west, east), 0, ceiling,
                      fmt::format("[{0},{1},{0},{2}]", solid, toEast, toWest));
  };
  const auto portal = [](const std::string& next) {
    return fmt::format("{{'next':'{}','texture':'#404040'}}", next);
  };
  const auto room = [](int i) { return fmt::format("room{}", i); };
  std::string sectors = sector("hall", 0, 8, 3, solid, portal("door")) + "," +
                        sector("door", 8, 9, 0, portal("hall"), portal(room(0)));
  for (int i = 0; i < rooms; ++i)
    sectors += "," + sector(room(i), 9 + i, 10 + i, 3, portal(i == 0 ? "door" : room(i - 1)),
                            i + 1 < rooms ? portal(room(i + 1)) : solid);
  return "{'light':0.3,'sectors':{" + sectors + "}}";
}

}  // namespace hearth::test
