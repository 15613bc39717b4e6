#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "support/level_text.h"

namespace hearth {

/// Rooms on both sides of a door, which is open from 0 to 2.
inline LoadedLevel roomsWithDoor(std::string_view steps = "'texture':'#808080'") {
  constexpr std::string_view kSolid = "{'texture':'#808080'}";
  const auto portal = [&](std::string_view next) {
    return fmt::format("{{'next':'{}',{}}}", next, steps);
  };
  return test::levelFrom(fmt::format(
      "{{'light':1,'sectors':{{{},{},{}}}}}",
      test::sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3,
                       fmt::format("[{0},{1},{0},{0}]", kSolid, portal("door"))),
      test::sectorText("door", "6,0, 7,0, 7,4, 6,4", 0, 2,
                       fmt::format("[{0},{{'next':'east','texture':'#808080'}},{0},{1}]", kSolid,
                                   portal("west"))),
      test::sectorText("east", "7,0, 9,0, 9,4, 7,4", 1, 3,
                       fmt::format("[{0},{0},{0},{1}]", kSolid, portal("door")))));
}

inline constexpr SectorId kDoor{std::size_t{1}};
inline constexpr std::size_t kWallToDoor = 1;  // of the west room

}  // namespace hearth
