// What texels get that have no sample.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "level/level.h"
#include "light/baking/left_out.h"
#include "light/baking/texel_sums.h"
#include "light/lightmap.h"
#include "light/polygons.h"
#include "light/used_texels.h"

namespace hearth {
namespace {

struct Place {
  int i;
  int j;
};

int distance2(Place a, Place b) { return (a.i - b.i) * (a.i - b.i) + (a.j - b.j) * (a.j - b.j); }

/// Those of a surface that fills a rectangle.
UsedTexels allUsed(const TexelRect& rect) {
  LitSurface surface;
  const double right = rect.i0 + rect.width;
  const double bottom = rect.j0 + rect.height;
  const Vec2 corner{static_cast<double>(rect.i0), static_cast<double>(rect.j0)};
  const std::vector<Vec2> outline{corner, {right, corner.y}, {right, bottom}, {corner.x, bottom}};
  surface.outline = Polygons({&outline, 1});
  surface.texels = rect;
  return {surface, rect};
}

/// Some texels of a rectangle are empty; each of the others has a level of its own.
TEST(EmptyTexels, takeTheLightOfOneOfTheNearestOthers) {
  std::mt19937 random(1);
  const auto below = [&](int end) {
    return static_cast<int>(random() % static_cast<unsigned>(end));
  };
  LightSource white;
  for (int round = 0; round < 300; ++round) {
    const TexelRect rect{below(9) - 4, below(9) - 4, 1 + below(20), 1 + below(12)};
    const int emptyOfTen = 1 + below(9);
    const UsedTexels all = allUsed(rect);
    EmptyTexels empty(all);
    TexelSums sums(rect, 1);
    std::vector<Place> emptied;
    std::vector<Place> byLevel(1);  // level 0 is dark
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i) {
        if (below(10) < emptyOfTen) {
          empty.add(i, j);
          emptied.push_back({i, j});
        } else {
          sums.add(i, j, white, static_cast<double>(byLevel.size()));
          byLevel.push_back({i, j});
        }
      }
    if (byLevel.size() == 1) continue;
    Lightmap filled = sums.toLightmap(1).value();
    empty.fill(filled);
    for (const Place at : emptied) {
      int least = std::numeric_limits<int>::max();
      for (std::size_t level = 1; level < byLevel.size(); ++level)
        least = std::min(least, distance2(at, byLevel[level]));
      EXPECT_EQ(distance2(at, byLevel[filled.at(at.i, at.j, 0)]), least) << at.i << ' ' << at.j;
    }
  }
}

}  // namespace
}  // namespace hearth
