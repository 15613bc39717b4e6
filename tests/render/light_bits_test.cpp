// That light of 16 bits is drawn with all of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "render/renderer.h"
#include "support/level_text.h"

namespace hearth {
namespace {

class LightBits : public testing::TestWithParam<const char*> {
 protected:
  Image draw(int bits, Channel channel) const {
    const BakedLight light = lightOf(bits);
    return Renderer(loaded_.level, loaded_.textures, light).draw(camera_, channel);
  }
  Image draw(int bits) const {
    const BakedLight light = lightOf(bits);
    return Renderer(loaded_.level, loaded_.textures, light).draw(camera_, LightMode::Only);
  }

 private:
  BakedLight lightOf(int bits) const {
    BakeSettings settings = loaded_.level.bake;
    settings.bits = bits;
    return bake(loaded_.level, settings, 2);
  }

  LoadedLevel loaded_ = test::levelFrom(
      "{'light':0,'sectors':{" + test::sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 4) + "}}",
      std::string("[{'x':2,'y':3,'z':3,'falloff':0.5,'color':'") + GetParam() + "'}]");
  Camera camera_{SectorId(0), {6, 6, 2}, 225, 0, 90, 323, 200};
};

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

TEST_P(LightBits, ofSixteenAreMixedLikeThoseOfEight) {
  // The channel samples each pixel's light by itself, in double precision.
  for (const int bits : {8, 16})
    EXPECT_LE(differing(draw(bits), draw(bits, Channel::Light)), 10) << bits;
}

TEST_P(LightBits, ofSixteenShowWhatEightRoundAway) {
  EXPECT_GT(differing(draw(16), draw(8)), 5000);
}

INSTANTIATE_TEST_SUITE_P(OfWhiteAndColoredLight, LightBits, testing::Values("#ffffff", "#ffc080"));

}  // namespace
}  // namespace hearth
