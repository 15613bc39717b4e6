// Holds what a wall grid finds against a look at all walls.

#include "level/wall_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory_resource>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "math/predicates.h"
#include "math/trig.h"

namespace hearth {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

Segment wall(Vec2 p0, Vec2 p1) {
  Segment segment;
  segment.p0 = p0;
  segment.p1 = p1;
  segment.length = length(p1 - p0);
  return segment;
}

/// Walls with the grid over them.
struct Walls {
  std::vector<Segment> walls;
  Box box;
  WallGrid grid;

  explicit Walls(std::vector<Segment> all)
      : walls(std::move(all)), box(boxAround(walls)), grid(walls, box, CellId(7)) {}

  static Box boxAround(const std::vector<Segment>& walls) {
    Box box;
    for (const Segment& segment : walls) box.add(segment.p0), box.add(segment.p1);
    return box;
  }
};

/// A number from 0 to 1, another one each time.
class Sequence {
 public:
  double next() { return place_ = std::fmod(place_ + 0.6180339887498949, 1.0); }
  double between(double low, double high) { return low + (high - low) * next(); }
  Vec2 in(const Box& box) { return {between(box.min.x, box.max.x), between(box.min.y, box.max.y)}; }

 private:
  double place_ = 0;
};

/// Square pillars, so many each way.
Walls pillars(int count, double size, Vec2 origin) {
  std::vector<Segment> walls;
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i) {
      const Vec2 a = origin + Vec2{2 * i * size, 2 * j * size};
      const Vec2 b = a + Vec2{size, 0};
      const Vec2 c = a + Vec2{size, size};
      const Vec2 d = a + Vec2{0, size};
      for (const auto& [from, to] : {std::pair{a, d}, {d, c}, {c, b}, {b, a}})
        walls.push_back(wall(from, to));
    }
  return Walls(std::move(walls));
}

/// A polygon round a point, with spikes that cross many cells.
Walls star(int spikes, double outer) {
  std::vector<Segment> walls;
  const auto corner = [&](int i) {
    const SinCos turn = sinCosDegrees(180.0 * i / spikes);
    return (i % 2 == 0 ? outer : 1) * Vec2{turn.cos, turn.sin};
  };
  for (int i = 0; i < 2 * spikes; ++i) walls.push_back(wall(corner(i), corner(i + 1)));
  return Walls(std::move(walls));
}

std::vector<Walls> manyWalls() {
  std::vector<Walls> all;
  all.push_back(pillars(1, 1, {0, 0}));
  all.push_back(pillars(12, 1, {-3, 5}));
  all.push_back(pillars(12, 0.37, {1e6, -1e6}));
  all.push_back(pillars(6, 1e4, {0, 0}));
  all.push_back(star(3, 2));
  all.push_back(star(200, 50));
  return all;
}

/// Where the ray meets the segment, beyond its origin.
std::optional<double> meeting(const Segment& segment, Vec2 origin, Vec2 delta) {
  const double side0 = cross(delta, segment.p0 - origin);
  const double side1 = cross(delta, segment.p1 - origin);
  if ((side0 >= 0) == (side1 >= 0)) return std::nullopt;
  const Vec2 p = lerp(segment.p0, segment.p1, side0 / (side0 - side1));
  const double t = dot(p - origin, delta) / dot(delta, delta);
  return t > 0 ? std::optional(t) : std::nullopt;
}

/// The walls of all cells that a ray visits up to `tEnd`.
std::set<std::uint32_t> along(const WallGrid& grid, Vec2 origin, Vec2 delta, double tEnd) {
  std::set<std::uint32_t> found;
  grid.alongRay(origin, delta, 0, [&](CellId cell) {
    for (const std::uint32_t i : grid.wallsIn(cell)) found.insert(i);
    return tEnd;
  });
  return found;
}

TEST(WallGrid, findsAllWallsThatARayMeetsUpToWhereItIsAsked) {
  for (const Walls& walls : manyWalls()) {
    Sequence numbers;
    const Box around = grown(walls.box, walls.box.longerSide() / 2);
    for (int ray = 0; ray < 400; ++ray) {
      const Vec2 origin = numbers.in(around);
      const Segment& aimedAt = walls.walls[static_cast<std::size_t>(
          numbers.next() * static_cast<double>(walls.walls.size()))];
      const Vec2 targets[] = {numbers.in(around), aimedAt.p0, {origin.x, aimedAt.p0.y}};
      const Vec2 delta = targets[ray % 3] - origin;
      if (delta == Vec2{}) continue;
      const double tEnd = ray % 2 == 0 ? kEndless : numbers.between(0, 2);
      const std::set<std::uint32_t> found = along(walls.grid, origin, delta, tEnd);
      for (std::uint32_t i = 0; i < walls.walls.size(); ++i)
        if (const auto t = meeting(walls.walls[i], origin, delta); t && *t <= tEnd) {
          EXPECT_TRUE(found.contains(i)) << "wall " << i << " at " << *t << " of ray " << ray;
        }
    }
  }
}

TEST(WallGrid, findsWallsThatARayRunsAlong) {
  const Walls walls = pillars(12, 1, {0, 0});
  for (const double y : {0.0, 1.0, 2.0, 22.0, 23.0}) {
    const std::set<std::uint32_t> found = along(walls.grid, {-5, y}, {1, 0}, kEndless);
    for (std::uint32_t i = 0; i < walls.walls.size(); ++i)
      if (walls.walls[i].p0.y == y || walls.walls[i].p1.y == y) {
        EXPECT_TRUE(found.contains(i)) << i;
      }
  }
}

TEST(WallGrid, stopsSoonBeyondWhereItIsAsked) {
  const Walls walls = pillars(50, 1, {0, 0});
  int cells = 0;
  walls.grid.alongRay({0.5, 1.5}, {1, 0.01}, 0, [&](CellId) {
    ++cells;
    return 3.0;
  });
  EXPECT_LE(cells, 2 + 3 / walls.grid.metresPerCell());
}

TEST(WallGrid, findsAllWallsUnderABoxOnceAndInOrder) {
  for (const Walls& walls : manyWalls()) {
    Sequence numbers;
    for (int k = 0; k < 200; ++k) {
      const Box box = boxOf(numbers.in(grown(walls.box, 1)), numbers.in(grown(walls.box, 1)));
      std::pmr::vector<std::uint32_t> found;
      walls.grid.addIn(box, found);
      EXPECT_TRUE(std::ranges::is_sorted(found, std::less_equal()));
      for (std::uint32_t i = 0; i < walls.walls.size(); ++i)
        if (box.contains(walls.walls[i].p0) || box.contains(walls.walls[i].p1)) {
          EXPECT_TRUE(std::ranges::binary_search(found, i));
        }
    }
  }
}

TEST(WallGrid, findsAllWallsInAnEndlessBox) {
  const Walls walls = pillars(12, 1, {0, 0});
  std::pmr::vector<std::uint32_t> found;
  walls.grid.addIn({{-kEndless, -kEndless}, {kEndless, kEndless}}, found);
  EXPECT_EQ(found.size(), walls.walls.size());
}

TEST(WallGrid, findsTheWallsUnderATriangleAndFewOthers) {
  const Walls walls = pillars(50, 1, {0, 0});
  const std::array<Vec2, 3> triangle{{{0.5, 0.5}, {98, 90}, {97, 96}}};
  std::pmr::vector<std::uint32_t> found;
  walls.grid.addUnder(triangle, found);
  const auto isInside = [&](Vec2 p) {
    return orientation(triangle[0], triangle[1], p) >= 0 &&
           orientation(triangle[1], triangle[2], p) >= 0 &&
           orientation(triangle[2], triangle[0], p) >= 0;
  };
  std::size_t inside = 0;
  for (std::uint32_t i = 0; i < walls.walls.size(); ++i)
    if (isInside(walls.walls[i].p0)) {
      ++inside;
      EXPECT_TRUE(std::ranges::binary_search(found, i));
    }
  EXPECT_GT(inside, 50U);
  EXPECT_LT(found.size(), 8 * inside);
}

TEST(WallGrid, takesNoMoreThanSomeBytesAWall) {
  for (const Walls& walls : manyWalls())
    EXPECT_LE(walls.grid.bytes(), 200 + 52 * walls.walls.size());
}

}  // namespace
}  // namespace hearth
