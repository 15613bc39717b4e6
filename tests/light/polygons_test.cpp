// Outlines of surfaces, by rows of points; and which texels pixels can ask for.

#include "light/polygons.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <span>

#include "light/used_texels.h"
#include "math/predicates.h"
#include "math/trig.h"
#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

std::size_t edgesWithin(const Polygons& outline, Vec2 p, double reach) {
  return outline.edgesWithin(p, reach, *std::pmr::get_default_resource()).size();
}

class PolygonsOfSurfaces : public testing::Test {
 protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  /// A star round a point, with a vertex every so often: those of some are whole numbers.
  std::vector<Vec2> star(Vec2 middle, double least, double most, bool isWhole) {
    std::vector<Vec2> points;
    for (int angle = 0; angle < 360; angle += 20) {
      const auto [sin, cos] = sinCosDegrees(angle);
      const Vec2 p = middle + between(least, most) * Vec2{cos, sin};
      points.push_back(isWhole ? Vec2{std::round(p.x), std::round(p.y)} : p);
    }
    return points;
  }

  /// Two stars side by side, one of which has a hole.
  Polygons outline(bool isWhole) {
    const std::vector stars{star({0, 0}, 6, 12, isWhole), star({0, 0}, 2, 5, isWhole),
                            star({26, 3}, 5, 12, isWhole)};
    return Polygons(stars);
  }

  std::mt19937 random_{1};
};

TEST_F(PolygonsOfSurfaces, aroundARowSayTheSameOfItsPoints) {
  for (int round = 0; round < 20; ++round) {
    const Polygons whole = outline(round % 2 == 0);
    Polygons around;
    for (double row = -14; row < 17; row += 0.5) {
      whole.findAroundRow(row, 2, around);
      for (double column = -14; column < 40; column += 0.5) {
        const Vec2 p{column, row};
        ASSERT_EQ(around.contains(p), whole.contains(p)) << column << ' ' << row;
        ASSERT_EQ(edgesWithin(around, p, 1.5), edgesWithin(whole, p, 1.5));
        if (const Vec2 nearest = whole.nearest(p); length(nearest - p) <= 2) {
          ASSERT_EQ(around.nearest(p), nearest) << column << ' ' << row;
        }
      }
    }
  }
}

/// The parts of a row that lie inside, farther than `margin` from all edges.
std::vector<Polygons::Stretch> insideAlong(const Polygons& outline, double row, double margin) {
  std::vector<Polygons::Beside> beside;
  outline.findBeside(row, margin, beside);
  std::vector<Polygons::Stretch> inside;
  for (std::size_t i = 0; i + 1 < beside.size(); ++i)
    if (beside[i].leadsInside) inside.push_back({beside[i].part.to, beside[i + 1].part.from});
  return inside;
}

bool isIn(std::span<const Polygons::Stretch> stretches, double column) {
  return std::ranges::any_of(stretches, [column](const Polygons::Stretch& stretch) {
    return stretch.from <= column && column <= stretch.to;
  });
}

/// Whether a point of the inside, or of an edge, is no farther than `margin` along both axes.
bool isNear(const Polygons& outline, Vec2 p, double margin) {
  const int steps = 8;
  for (int j = -steps; j <= steps; ++j)
    for (int i = -steps; i <= steps; ++i)
      if (outline.contains(p +
                           margin / steps * Vec2{static_cast<double>(i), static_cast<double>(j)}))
        return true;
  return false;
}

TEST_F(PolygonsOfSurfaces, alongARowAreInsideAsFarFromEdgesAsAsked) {
  for (int round = 0; round < 20; ++round) {
    const Polygons found = outline(round % 2 == 0);
    for (double row = -13; row < 16; row += 1.5) {
      const std::vector<Polygons::Stretch> inside = insideAlong(found, row, 0.25);
      for (double column = -14; column < 40; column += 0.0625) {
        const Vec2 p{column, row};
        if (isIn(inside, column)) {
          ASSERT_TRUE(found.contains(p)) << column << ' ' << row;
        }
        if (isIn(inside, column)) {
          ASSERT_TRUE(edgesWithin(found, p, 0.2499) == 0);
        }
        if (found.contains(p) && edgesWithin(found, p, 0.36) == 0) {
          ASSERT_TRUE(isIn(inside, column)) << column << ' ' << row;
        }
      }
    }
  }
}

TEST_F(PolygonsOfSurfaces, alongARowAreNearWhereTheyHaveAPointWithinTheMargin) {
  int nearButOutside = 0;
  for (int round = 0; round < 6; ++round) {
    const Polygons found = outline(round % 2 == 0);
    const double firstRow = -15 + round * 0.3;
    const int rows = 33;
    const ListPerRow<Polygons::Stretch> nearRows = found.nearAlongRows(firstRow, rows, 1);
    for (int j = 0; j < rows; ++j) {
      const double row = firstRow + j;
      const std::span<const Polygons::Stretch> near = nearRows.row(j);
      for (double column = -15; column < 41; column += 0.5) {
        const Vec2 p{column, row};
        if (isNear(found, p, 1)) {
          ASSERT_TRUE(isIn(near, column)) << column << ' ' << row;
        }
        if (isIn(near, column)) {
          ASSERT_TRUE(isNear(found, p, 1.3)) << column << ' ' << row;
        }
        nearButOutside += isIn(near, column) && !found.contains(p) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(nearButOutside, 100);
}

/// A gallery round a yard that nobody comes to, with a corner that points inwards.
test::BakedRoom gallery() {
  return {fmt::format("{{'light':0,'sectors':{{'gallery':{{'floor':{{'z':0,'texture':'#808080'}},"
                      "'ceiling':{{'z':3,'texture':'#808080'}},'loops':{{"
                      "'border':{{'v':[0.1,0, 9,0, 9.3,7, 5,4.1, 0,7],'walls':{0}}},"
                      "'inner':{{'v':[2,3, 6.5,3, 6.4,1, 2,1.1],'walls':{0}}}}}}}}}}}",
                      "{'texture':'#808080'}"),
          "[{'x':1,'y':1,'z':1.5,'falloff':0.3},{'x':8,'y':2,'z':1.5,'falloff':0.3}]"};
}

TEST(UsedTexels, areThoseThatBilinearFilteringReads) {
  const test::BakedRoom room = gallery();
  for (const auto& surface : room.light().surfaces) {
    if (!surface) continue;
    const TexelRect& rect = surface->texels;
    const ListPerRow<LitSurface::TexelRun> used = surface->usedRuns(rect.j0, rect.height);
    const auto expectAsked = [&](int i, int j) {
      EXPECT_TRUE(std::ranges::any_of(
          used.row(j - rect.j0),
          [i](const LitSurface::TexelRun& row) { return row.first <= i && i <= row.last; }))
          << i << ' ' << j;
    };
    for (double t = rect.j0; t < rect.j0 + rect.height; t += 0.37)
      for (double s = rect.i0; s < rect.i0 + rect.width; s += 0.29) {
        if (!surface->outline.contains({s, t})) continue;
        const int i = static_cast<int>(std::floor(s - 0.5));
        const int j = static_cast<int>(std::floor(t - 0.5));
        for (const int down : {0, 1})
          for (const int right : {0, 1}) expectAsked(i + right, j + down);
      }
  }
}

TEST(UsedTexels, areRepeatedWhereNoPixelReads) {
  const test::BakedRoom room = gallery();
  const std::optional<SurfaceId> floor = room.surfaceAt(SurfaceKind::Floor, {1, 1, 0}, "");
  const LitSurface& surface = *room.light().surfaces[floor->index()];
  const Lightmap& light = *room.light().lightmaps[floor->index()];
  const TexelRect& rect = surface.texels;
  const ListPerRow<LitSurface::TexelRun> runs = surface.usedRuns(rect.j0, rect.height);
  int gaps = 0;
  for (int j = rect.j0; j < rect.j0 + rect.height; ++j) {
    const std::span<const LitSurface::TexelRun> used = runs.row(j - rect.j0);
    for (std::size_t k = 1; k < used.size(); ++k, ++gaps) {
      // A gap of one texel is as near to either.
      const int before = used[k - 1].last;
      const int after = used[k].first;
      EXPECT_EQ(light.at(before + 1, j), light.at(after == before + 2 ? after : before, j));
      EXPECT_EQ(light.at(after - 1, j), light.at(after, j));
    }
    for (int i = rect.i0; i < used.front().first; ++i)
      EXPECT_EQ(light.at(i, j), light.at(used.front().first, j));
  }
  EXPECT_GT(gaps, 20);
}

TEST(UsedTexels, leaveEachOtherTexelTheNearestInItsRow) {
  const test::BakedRoom room = gallery();
  const std::optional<SurfaceId> floor = room.surfaceAt(SurfaceKind::Floor, {1, 1, 0}, "");
  const LitSurface& surface = *room.light().surfaces[floor->index()];
  const TexelRect& all = surface.texels;
  const ListPerRow<LitSurface::TexelRun> runs = surface.usedRuns(all.j0, all.height);
  int outside = 0;
  for (const TexelRect& rect : {all, TexelRect{all.i0 + 30, all.j0 + 9, 25, 20}}) {
    const UsedTexels texels(surface, rect);
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j) {
      std::vector<int> nearest(static_cast<std::size_t>(rect.width), rect.i0 - 1);
      const auto at = [&](int i) -> int& { return nearest[static_cast<std::size_t>(i - rect.i0)]; };
      texels.forEachRunIn(rect, j, [&](int first, int last) {
        for (int i = first; i <= last; ++i) at(i) = i;
      });
      texels.forEachUnused(j, [&](int i, int used) {
        EXPECT_LT(at(i), rect.i0) << i << ' ' << j << " is used";
        at(i) = used;
      });
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i) {
        int least = rect.width + all.width;
        for (const auto& [first, last] : runs.row(j - all.j0))
          least = std::min(least, std::abs(std::clamp(i, first, last) - i));
        if (at(i) < rect.i0)
          ++outside;  // that one is not in the rectangle
        else
          EXPECT_EQ(std::abs(at(i) - i), least) << i << ' ' << j;
      }
    }
    EXPECT_EQ(outside > 0, rect != all);
  }
}

}  // namespace
}  // namespace hearth
