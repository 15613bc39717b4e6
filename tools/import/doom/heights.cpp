#include "import/doom/heights.h"

#include <algorithm>
#include <array>
#include <climits>
#include <optional>
#include <set>

namespace hearth::doom {

namespace {

// What a line does, by its number (https://doomwiki.org/wiki/Linedef_type), of which only what
// opens doors and lowers lifts counts here.

/// Doors behind the line itself.
constexpr std::array kOpensBehind{1, 26, 27, 28, 31, 32, 33, 34, 117, 118};
/// Doors in the sectors that have the line's tag.
constexpr std::array kOpensTagged{2,   4,   29,  46,  61,  63,  86,  90,  99,  103, 105, 106,
                                  108, 109, 111, 112, 114, 115, 133, 134, 135, 136, 137};
constexpr std::array kLowersLift{10, 21, 62, 88, 120, 121, 122, 123};

/// An open door ends so many units below the lowest ceiling around.
constexpr int kLintel = 4;

template <std::size_t N>
bool isOneOf(const std::array<int, N>& specials, int special) {
  return std::ranges::find(specials, special) != specials.end();
}

/// Of the sectors of a map.
struct Movers {
  std::set<std::uint32_t> doors;
  std::set<std::uint32_t> lifts;
};

Movers moversOf(const Map& map) {
  Movers movers;
  for (const Line& line : map.lines) {
    if (isOneOf(kOpensBehind, line.special) && line.sides[1])
      movers.doors.insert(map.sides[*line.sides[1]].sector);
    const bool opens = isOneOf(kOpensTagged, line.special);
    const bool lowers = isOneOf(kLowersLift, line.special);
    if (line.tag == 0 || (!opens && !lowers)) continue;
    for (std::uint32_t i = 0; i < map.sectors.size(); ++i)
      if (map.sectors[i].tag == line.tag) (opens ? movers.doors : movers.lifts).insert(i);
  }
  return movers;
}

/// By sector, those on the other sides of its lines.
std::vector<std::set<std::uint32_t>> neighboursOf(const Map& map) {
  std::vector<std::set<std::uint32_t>> neighbours(map.sectors.size());
  for (const Line& line : map.lines) {
    if (!line.sides[0] || !line.sides[1]) continue;
    const std::uint32_t a = map.sides[*line.sides[0]].sector;
    const std::uint32_t b = map.sides[*line.sides[1]].sector;
    if (a == b) continue;
    neighbours[a].insert(b);
    neighbours[b].insert(a);
  }
  return neighbours;
}

}  // namespace

std::vector<Heights> heightsOf(const Map& map, Doors doors) {
  std::vector<Heights> heights;
  for (const Sector& sector : map.sectors) heights.push_back({sector.floor, sector.ceiling});
  if (doors == Doors::Closed) return heights;
  const auto neighbours = neighboursOf(map);
  const Movers movers = moversOf(map);
  for (const std::uint32_t door : movers.doors) {
    std::optional<int> lowest;  // around; leaves of one door open together
    for (const std::uint32_t neighbour : neighbours[door])
      if (!movers.doors.contains(neighbour))
        lowest = std::min(map.sectors[neighbour].ceiling, lowest.value_or(INT_MAX));
    if (lowest) heights[door].ceiling = std::max(heights[door].ceiling, *lowest - kLintel);
  }
  for (const std::uint32_t lift : movers.lifts)
    for (const std::uint32_t neighbour : neighbours[lift])
      heights[lift].floor = std::min(heights[lift].floor, map.sectors[neighbour].floor);
  return heights;
}

}  // namespace hearth::doom
