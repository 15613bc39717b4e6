#include "scenes.h"

#include <algorithm>
#include <random>

namespace hearth {

namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double between(double a, double b) {
    return a + (b - a) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  bool chance(double fraction) { return between(0, 1) < fraction; }
  std::size_t below(std::size_t count) { return bits_() % count; }

 private:
  std::mt19937_64 bits_;
};

/// (n + 1) x (n + 1) vertices of a square, those inside it moved at random.
struct CrookedGrid {
  std::size_t n;
  std::vector<Vec2> vertices;

  CrookedGrid(std::size_t cells, double size, Random& random) : n(cells) {
    const double pitch = size / static_cast<double>(n);
    for (std::size_t row = 0; row <= n; ++row) {
      for (std::size_t column = 0; column <= n; ++column) {
        const bool isInside = row > 0 && row < n && column > 0 && column < n;
        const double reach = isInside ? 0.3 * pitch : 0;
        vertices.push_back({static_cast<double>(column) * pitch + random.between(-reach, reach),
                            static_cast<double>(row) * pitch + random.between(-reach, reach)});
      }
    }
  }

  std::vector<Vec2> cell(std::size_t row, std::size_t column) const {
    const auto at = [&](std::size_t r, std::size_t c) { return vertices[r * (n + 1) + c]; };
    return {at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)};
  }
};

/// A sector for each cell, all neighbours linked, of heights that `heights()` gives.
template <typename HeightsOf>
std::vector<SectorId> addCells(TestLevel& level, const CrookedGrid& grid, HeightsOf heights) {
  std::vector<SectorId> cells;
  for (std::size_t i = 0; i < grid.n * grid.n; ++i) {
    cells.push_back(level.addSector(std::to_string(i), heights()));
    level.addLoop(cells.back(), grid.cell(i / grid.n, i % grid.n));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if ((i + 1) % grid.n != 0) level.link(cells[i], cells[i + 1]);
    if (i + grid.n < cells.size()) level.link(cells[i], cells[i + grid.n]);
  }
  return cells;
}

/// A wedge whose lowest vertex is `low` above the flat; with a negative sign it hangs from it.
Slope slopeOver(const std::vector<Vec2>& outline, double zFlat, Vec2 gradient, double low,
                double sign, TestLevel& level) {
  Slope slope;
  slope.origin = outline.front();
  slope.gradient = sign * gradient;
  double lowest = 0;
  for (const Vec2 p : outline) lowest = std::min(lowest, dot(gradient, p - slope.origin));
  slope.zAt0 = zFlat + sign * (low - lowest);
  slope.sidewall = level.texture();
  return slope;
}

void makeStack(TestLevel& level, SectorId id, Random& random) {
  const std::size_t index = random.below(4);
  const Portal* portal = std::get_if<Portal>(&level.wall(id, index).wall);
  if (!portal) return;
  const double height = level.sector(id).ceiling.z - level.sector(id).floor.z;
  Stack stack;
  stack.subWalls = {{0.2 * height, Solid{*portal->lower}},
                    {0.7 * height, *portal},
                    {height, Solid{*portal->upper}}};
  if (random.chance(0.5)) stack.subWalls.erase(stack.subWalls.begin());
  level.wall(id, index).wall = stack;
}

}  // namespace

TestScene yardScene() {
  TestScene made{"yard", 20, {}};
  TestLevel& level = made.level;
  const SectorId yard = level.addBox("yard", {0, 0}, {10, 12}, {0, 5});
  level.addLoop(yard, {{2, 2}, {2, 3}, {3, 3.5}, {3, 2}});          // a pillar
  level.addLoop(yard, {{5, 5}, {5, 8}, {6.5, 9}, {8, 8}, {8, 5}});  // a pool
  const SectorId pool = level.addSector("pool", {-1, 5});
  level.addLoop(pool, {{5, 5}, {8, 5}, {8, 8}, {6.5, 9}, {5, 8}});
  const SectorId terrace = level.addBox("terrace", {10, 0}, {20, 12}, {0.5, 8});
  const SectorId ramp = level.addBox("ramp", {0, 12}, {10, 16}, {0, 4});
  const SectorId door = level.addBox("door", {10, 12}, {20, 14}, {0.5, 0.5});
  const SectorId vault = level.addBox("vault", {10, 14}, {20, 16}, {0, 3});
  for (const SectorId id : {yard, pool, terrace}) level.sector(id).ceiling.isSky = true;
  for (const SectorId id : {pool, terrace, ramp}) level.link(yard, id);
  level.link(terrace, door);
  level.link(door, vault);
  level.sector(ramp).floorSlope = slopeOver({{0, 12}, {10, 12}}, 0, {0.1, 0.2}, 0, 1, level);
  level.sector(ramp).ceilingSlope =
      slopeOver({{0, 12}, {10, 12}, {10, 16}, {0, 16}}, 4, {0, 0.1}, 0.2, -1, level);
  TextureMapping fence = level.texture();
  fence.repeat = {3, 1.5};
  fence.zRef = 2;
  std::get<Portal>(level.wall(yard, 1).wall).maskedMiddle = fence;
  Segment& wall = level.wall(yard, 2);
  const Portal portal = std::get<Portal>(wall.wall);
  Stack stack;
  stack.subWalls = {{0.4, Solid{*portal.lower}}, {3, portal}, {5, Solid{*portal.upper}}};
  wall.wall = stack;
  return made;
}

TestScene storeysScene(std::uint64_t seed) {
  TestScene made{"storeys " + std::to_string(seed), 30, {}};
  Random random(seed);
  const CrookedGrid lowerGrid(4, made.size, random);
  const CrookedGrid upperGrid(3, made.size, random);
  const std::vector<SectorId> lower = addCells(made.level, lowerGrid, [&] {
    return TestLevel::Heights{random.between(-1, 1), 3};
  });
  const std::vector<SectorId> upper = addCells(made.level, upperGrid, [&] {
    return TestLevel::Heights{3, random.between(4, 6)};
  });
  // Walls below hold the upper floors up: no storey is one open hall.
  for (std::size_t i = 0; i < lower.size(); i += 3)
    made.level.wall(lower[i], random.below(4)).wall = Solid{made.level.texture()};
  made.level.connect(upper, lower);
  return made;
}

TestScene gridScene(std::uint64_t seed) {
  Random random(seed);
  const double size = random.between(10, 100);
  TestScene made{"grid " + std::to_string(seed), size, {}};
  const CrookedGrid grid(6, size, random);
  const double floors[] = {0, 0, 0.5, 1};
  const double ceilings[] = {2, 3, 3, 4};
  const std::vector<SectorId> cells = addCells(made.level, grid, [&] {
    const double floor = floors[random.below(4)];
    return TestLevel::Heights{floor, random.chance(0.07) ? floor : ceilings[random.below(4)]};
  });
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Sector& sector = made.level.sector(cells[i]);
    if (sector.floor.z == sector.ceiling.z) continue;
    const double steepest = 1.2 / size;  // no more than 0.4 m in a cell, of 1 m of air at least
    const auto gradient = [&] {
      return Vec2{random.between(-steepest, steepest), random.between(-steepest, steepest)};
    };
    const auto low = [&] { return random.chance(0.5) ? 0.1 : 0; };
    const std::vector<Vec2> outline = grid.cell(i / grid.n, i % grid.n);
    if (random.chance(0.4))
      sector.floorSlope = slopeOver(outline, sector.floor.z, gradient(), low(), 1, made.level);
    else
      sector.floor.isSky = random.chance(0.3);
    if (random.chance(0.3))
      sector.ceilingSlope = slopeOver(outline, sector.ceiling.z, gradient(), low(), -1, made.level);
    else
      sector.ceiling.isSky = random.chance(0.4);
    if (random.chance(0.2)) makeStack(made.level, cells[i], random);
  }
  return made;
}

}  // namespace hearth
