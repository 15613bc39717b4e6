#pragma once

#include <string>
#include <variant>
#include <vector>

#include "test_level.h"
#include "truth/thing_sectors.h"

namespace hearth {

/// The names of the sectors that a thing is in, in the order of the level.
inline std::string namesOf(const Level& level, SectorId sector, const std::vector<Polygon>& thing) {
  const std::vector<bool> isIn = sectorsCrossedBy(level, sector, thing);
  std::string names;
  for (std::size_t i = 0; i < isIn.size(); ++i)
    if (isIn[i]) names += level.sectors[i].name;
  return names;
}

/// Rooms of 4 x 4 m along x, "a", "b" and so on, open to one another.
struct Row {
  TestLevel test;
  std::vector<SectorId> rooms;

  explicit Row(const std::vector<TestLevel::Heights>& heights) {
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const double x = 4 * static_cast<double>(i);
      rooms.push_back(
          test.addBox(std::string(1, static_cast<char>('a' + i)), {x, 0}, {x + 4, 4}, heights[i]));
      if (i > 0) test.link(rooms[i - 1], rooms[i]);
    }
  }
  /// Walls off the first two rooms from each other.
  void close() {
    test.wall(rooms[0], 1).wall = Solid{test.texture()};
    test.wall(rooms[1], 3).wall = Solid{test.texture()};
  }
  /// Between the first two rooms, as the first sees it, leaves open only what is 1 to 2 m high.
  void leaveHatch() {
    Segment& wall = test.wall(rooms[0], 1);
    const Portal portal = std::get<Portal>(wall.wall);
    Stack stack;
    stack.subWalls = {{1, Solid{*portal.lower}}, {2, portal}, {4, Solid{*portal.upper}}};
    wall.wall = stack;
  }
  std::string names(const Polygon& polygon, std::size_t from = 0) {
    return namesOf(test.finished(), rooms[from], {polygon});
  }
};

/// Two rooms below, walled off from each other: "a" at x from 0 to 4, and "b" from 4 to 8; above
/// them "c" from 0 to 3, and "d" from 3 to 8.
struct Storeys {
  TestLevel test;
  std::vector<SectorId> lower{test.addBox("a", {0, 0}, {4, 4}, {0, 3}),
                              test.addBox("b", {4, 0}, {8, 4}, {0, 3})};
  std::vector<SectorId> upper{test.addBox("c", {0, 0}, {3, 4}, {3, 6}),
                              test.addBox("d", {3, 0}, {8, 4}, {3, 6})};

  Storeys() { test.connect(upper, lower); }
  std::string names(SectorId from, const Polygon& polygon) {
    return namesOf(test.finished(), from, {polygon});
  }
};

}  // namespace hearth
