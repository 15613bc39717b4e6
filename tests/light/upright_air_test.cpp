#include "light/grid/upright_air.h"

#include <gtest/gtest.h>

#include "light/grid/grids.h"
#include "support/level_text.h"

namespace hearth {
namespace {

/// Two triangles that stand on 0 and reach 1 m high, the first up to the fraction 0.5 of their
/// segment, the second from `gap` beyond it.
const UprightOutline kFirst = {{0, 0}, {0.5, 0}, {0.5, 1}};
UprightOutline second(double gap) { return {{0.5 + gap, 0}, {1, 0}, {0.5 + gap, 1}}; }

TEST(UprightAir, hasACommonEdgeWhereTheGapInMetresIsRounding) {
  // 4e-10 of a segment: rounding on one of 1 m, 0.4 mm on one of 1000 km.
  EXPECT_TRUE(commonEdge(kFirst, second(4e-10), 1));
  EXPECT_FALSE(commonEdge(kFirst, second(4e-10), 1e6));
  EXPECT_TRUE(commonEdge(kFirst, second(0), 1e6));
  // 2 mm of common height are a length, on a segment of any length.
  EXPECT_TRUE(commonEdge({{0, 0}, {0.5, 0}, {0.5, 0.002}}, {{0.5, 0}, {1, 0}, {0.5, 0.002}}, 1e6));
}

TEST(UprightAir, reachesAnEndOfItsSegmentWhereTheGapInMetresIsRounding) {
  const UprightOutline air = {{0, 0}, {1 - 4e-10, 0}, {1 - 4e-10, 2}, {0, 2}};
  EXPECT_EQ(heightsAt(air, 1, 1), (std::pair<double, double>(0, 2)));
  const auto [low, high] = heightsAt(air, 1, 1e6);
  EXPECT_GT(low, high);
}

TEST(UprightAir, ofAHangingWedgeEndsAtTheStandingOneThatItPassesByNoise) {
  // They touch in the corner (4, 0), apart from half a millimetre.
  const std::string wall = "{'next':'b','texture':'#808080'}";
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" +
      test::sectorText(
          "a", "0,0, 4,0, 4,4, 0,4", 0, 3,
          "[{'texture':'#808080'}," + wall + ",{'texture':'#808080'},{'texture':'#808080'}]") +
      "," +
      test::sectorText("b", "4,0, 8,0, 8,4, 4,4", 0, 3,
                       "[{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'},"
                       "{'next':'a','texture':'#808080'}]",
                       ",'slopeFloor':{'z':[1,1,0,0],'sidewall':'#808080'},"
                       "'slopeCeil':{'z':[2.0005,2.0005,0,0],'sidewall':'#808080'}") +
      "}}");
  std::vector<double> ends;
  for (const SurfaceId id : loaded.scene().shownSurfaces()) {
    const Surface& surface = loaded.level[id];
    if (!isSidewall(surface.kind)) continue;
    const auto [low, high] = heightsAt(uprightAir(loaded.scene(), id), 0, 4);
    ends.push_back(surface.kind == SurfaceKind::FloorSidewall ? high : low);
  }
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NEAR(ends[0], 1, 1e-12);
  EXPECT_NEAR(ends[1], 1, 1e-12);
}

TEST(SlopeGrid, runsUphillHoweverGentleTheSlopeOfALargeSector) {
  // 0.8 mm over 1000 km.
  const LoadedLevel loaded = test::levelFrom(
      "{'light':1,'sectors':{" +
      test::sectorText("plain", "0,0, 1e6,0, 1e6,1e6, 0,1e6", 0, 3, "{'texture':'#808080'}",
                       ",'slopeFloor':{'z':[0,8e-4,8e-4,0]}") +
      "}}");
  const std::vector<TexelGrid> grids = slopeGrids(loaded.scene(), true, 1);
  EXPECT_NEAR(grids.front().axisT.x, 1, 1e-9);
  EXPECT_NEAR(grids.front().axisT.z, 8e-10, 1e-12);
}

}  // namespace
}  // namespace hearth
