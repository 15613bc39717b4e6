// That light is mixed between the texels of a lightmap as in double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "render/renderer.h"
#include "support/level_text.h"

namespace hearth {
namespace {

class LightMixture : public testing::TestWithParam<const char*> {};

/// Pixels of two pictures that differ, and none by more than a level.
int differing(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgb p = a.pixels()[i];
    const Rgb q = b.pixels()[i];
    EXPECT_LE(std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}), 1);
    count += p == q ? 0 : 1;
  }
  return count;
}

TEST_P(LightMixture, isThatOfDoublePrecisionButForOnePixelInAHundred) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light':0,'sectors':{" + test::sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 4) + "}}",
      std::string("[{'x':2,'y':3,'z':3,'falloff':0.5,'color':'") + GetParam() + "'}]");
  const Camera camera{SectorId(0), {6, 6, 2}, 225, 0, 90, 323, 200};
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 2);
  const Renderer renderer(loaded.scene(), loaded.textures, light);
  // The channel samples each pixel's light by itself, in double precision.
  const Image mixed = renderer.draw(camera, LightMode::Only);
  EXPECT_LE(differing(mixed, renderer.draw(camera, Channel::Light)),
            camera.width * camera.height / 100);
}

INSTANTIATE_TEST_SUITE_P(OfWhiteAndColoredLight, LightMixture,
                         testing::Values("#ffffff", "#ffc080"));

}  // namespace
}  // namespace hearth
