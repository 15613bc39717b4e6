// Samples where the edges of shadows need them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "light/bakery.h"
#include "light/sampling/sample_placement.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::levelFrom;
using test::sectorText;

TEST(Sampling, asShadowsNeedIsTheSampleInTheMiddleWhereThereAreNone) {
  const BakedRoom room(
      fmt::format("{{'light': 0, 'sectors': {{{}}}}}",
                  sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3)),
      "{'bake': {'texel': 0.125}, 'lights': [{'x':2,'y':1.5,'z':1.2,'falloff':0.5}]}");
  BakeSettings settings = room.level().bake;
  settings.samples.reset();
  const BakedLight light = bake(room.scene(), settings, 1);
  for (std::size_t s = 0; s < light.lightmaps.size(); ++s) {
    const std::vector<std::uint8_t>& found = light.lightmaps[s]->levels;
    const std::vector<std::uint8_t>& middle = room.light().lightmaps[s]->levels;
    ASSERT_EQ(found.size(), middle.size());
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], middle[i], 1);
  }
}

TEST(Sampling, asShadowsNeedClipsTexelsAtTheShadowsEdge) {
  const BakedRoom room(
      fmt::format("{{'light': 0, 'sectors': {{{}, {}}}}}",
                  sectorText("west", "0,0, 2,0, 2,2, 2,4, 0,4", 0, 3,
                             "[{'texture':'#808080'},{'texture':'#808080'},"
                             "{'next':'east','texture':'#808080'},{'texture':'#808080'},"
                             "{'texture':'#808080'}]"),
                  sectorText("east", "2,0, 6,0, 6,4, 2,4, 2,2", 0, 3,
                             "[{'texture':'#808080'},{'texture':'#808080'},"
                             "{'texture':'#808080'},{'next':'west','texture':'#808080'},"
                             "{'texture':'#808080'}]")),
      "{'bake': {'texel': 0.5, 'samples': 'auto'},"
      " 'lights': [{'x':1,'y':2.25,'z':1.2,'intensity':200}]}");
  // East of x = 2 light arrives on the side of the line from (1, 2.25) through (2, 2): y = 2.5 -
  // x/4.
  const Lightmap& floor =
      *room.light().lightmaps[room.surfaceAt(SurfaceKind::Floor, {4, 1, 0}, "east")->index()];
  for (int i = 5; i < 11; ++i)
    for (int j = 0; j < 7; ++j) {
      double lit = 0;
      for (int k = 0; k < 1000; ++k) {
        const double y = 2.5 - (i + (k + 0.5) / 1000) * 0.5 / 4;
        lit += std::clamp(j + 1 - y / 0.5, 0.0, 1.0) / 1000;
      }
      EXPECT_NEAR(floor.at(i, j), 200 * lit, 3) << i << ' ' << j;
    }
}

TEST(SamplePlacement, keepsAHairOffBothEdgesOfASharpCorner) {
  for (const double angle : {1.0, 3.0, 10.0, 21.0})
    for (const double turn : {0.0, 7.0, 100.0, 201.5}) {
      // The floor of a room with a corner at (0, 0), which opens from `turn` on.
      const SinCos a = sinCosDegrees(turn);
      const SinCos b = sinCosDegrees(turn + angle);
      const std::string vertices =
          fmt::format("0,0, {},{}, {},{}", 4 * a.cos, 4 * a.sin, 4 * b.cos, 4 * b.sin);
      const LoadedLevel loaded = levelFrom(
          fmt::format("{{'light': 0, 'sectors': {{{}}}}}", sectorText("room", vertices, 0, 3)));
      const LitSurfaces surfaces = makeLitSurfaces(loaded.scene(), 0.25);
      for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (loaded.level.surfaces[i].kind != SurfaceKind::Floor) continue;
        const LitSurface& floor = *surfaces[i];
        const SinCos beyond = sinCosDegrees(turn + angle / 2 + 180);
        const Vec2 sample = floor.grid.toTexels({0.1 * beyond.cos, 0.1 * beyond.sin, 0});
        const Vec3 target = SamplePlacement(surfaces, SurfaceId(i)).place(sample).target;
        const Vec2 found = floor.grid.toTexels(target);
        EXPECT_TRUE(floor.outline.contains(found)) << angle << ' ' << turn;
        EXPECT_GT(0.25 * length(floor.outline.nearest(found) - found), 0.9 * kEdgeInset)
            << angle << ' ' << turn;
      }
    }
}

}  // namespace
}  // namespace hearth
