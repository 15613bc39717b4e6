#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "import/doom/map.h"

namespace hearth::doom {

/// A map made of lines between places. Lengths are in map units, y grows up.
class MapBuilder {
 public:
  MapBuilder() { map.name = "MAP01"; }

  std::uint32_t sector(int floor = 0, int ceiling = 128) {
    map.sectors.push_back({floor, ceiling, "FLOOR", "CEIL", 160, 0, 0});
    return static_cast<std::uint32_t>(map.sectors.size() - 1);
  }

  /// A line with a sector to its right and one to its left, or none.
  Line& line(Vertex from, Vertex to, std::optional<std::uint32_t> right,
             std::optional<std::uint32_t> left = std::nullopt) {
    map.lines.push_back({vertex(from), vertex(to), 0, 0, 0, {side(right), side(left)}});
    if (right && left)
      for (const auto& both : map.lines.back().sides) map.sides[*both].middle = "-";
    return map.lines.back();
  }

  /// Walls round a sector, clockwise as seen with y upwards.
  void walls(std::uint32_t sector, const std::vector<Vertex>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      line(corners[i], corners[(i + 1) % corners.size()], sector);
  }

  Side& sideOf(const Line& line, std::size_t i = 0) { return map.sides[*line.sides[i]]; }

  Map map;

 private:
  std::uint32_t vertex(Vertex place) {
    map.vertices.push_back(place);
    return static_cast<std::uint32_t>(map.vertices.size() - 1);
  }
  std::optional<std::uint32_t> side(std::optional<std::uint32_t> sector) {
    if (!sector) return std::nullopt;
    map.sides.push_back({0, 0, "UPPER", "LOWER", "WALL", *sector});
    return static_cast<std::uint32_t>(map.sides.size() - 1);
  }
};

inline std::vector<Vertex> square(int x, int y, int side) {
  return {{x, y}, {x, y + side}, {x + side, y + side}, {x + side, y}};
}

}  // namespace hearth::doom
