#include "settings/measured_figures.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "../loaded.h"
#include "settings/approximations.h"
#include "settings/quality.h"
#include "settings/settings.h"

namespace hearth {
namespace {

void expectSame(const std::optional<Figure>& a, const std::optional<Figure>& b) {
  ASSERT_TRUE(a);
  ASSERT_TRUE(b);
  EXPECT_EQ(a->cost, b->cost);
  EXPECT_EQ(a->off, b->off);
}

TEST(MeasuredFigures, ofOneValueAreThoseOfItsBakeOrFrame) {
  const LoadedLevel gaol = loaded("levels/gaol.json");  // which has a masked middle texture
  for (const BakeSettings& authored : {BakeSettings{}, gaol.level.bake}) {
    Level level = gaol.level;
    level.bake = authored;
    const Scene scene(level, gaol.geometry);
    for (const Approximation& approximation : approximations())
      for (const std::string_view value : triedOf(approximation)) {
        const Option option = approximation.setting;
        SCOPED_TRACE(std::string(row(option).name) + ' ' + std::string(value));
        OptionValues values;
        values.set(option, std::string(value));
        const BakeSettings bake = bakeSettingsFrom(scene, values);
        const DrawSettings draw = drawSettingsFrom(values);
        if (approximation.of == Approximation::Of::Movers) continue;  // measured alone only
        if (bake != authored)
          expectSame(figureOf(bake, authored), figureOf(option, value, valueOf(authored, option)));
        if (draw != DrawSettings{})
          expectSame(figureOf(draw), figureOf(option, value, valueOf(DrawSettings{}, option)));
      }
  }
}

TEST(MeasuredFigures, areOfEveryQuality) {
  for (const Quality& quality : qualities()) {
    const BakeSettings bake = quality.bake.appliedTo({});
    EXPECT_TRUE(bake == BakeSettings{} || figureOf(bake, {})) << quality.name;
    EXPECT_TRUE(figureOf(quality.draw)) << quality.name;
  }
}

TEST(MeasuredFigures, areHeldAgainstTheLevelsOwnValue) {
  const auto own = figureOf(Option::Texel, "0.0625", "0.0625");
  ASSERT_TRUE(own);
  EXPECT_EQ(own->cost, 1);
  const auto coarse = figureOf(Option::Texel, "0.125", "0.0625");
  const auto fine = figureOf(Option::Texel, "0.0625", "0.125");
  ASSERT_TRUE(coarse && fine);
  EXPECT_DOUBLE_EQ(coarse->cost, 1 / fine->cost);
  EXPECT_GT(coarse->off, fine->off);
}

TEST(MeasuredFigures, areNoneOfWhatWasNotMeasured) {
  EXPECT_FALSE(figureOf(Option::Texel, "0.3", "0.125"));
  EXPECT_FALSE(figureOf(Option::Texel, "0.125", "0.3"));
  BakeSettings authored;
  authored.texel = 0.3;
  EXPECT_FALSE(figureOf(BakeSettings{}, authored));
  BakeSettings lambert;
  lambert.lambert = true;
  EXPECT_FALSE(figureOf(lambert, {}));
  EXPECT_FALSE(figureOf({.textureFilter = TextureFilter::Bilinear, .pixelSize = 2}));
}

}  // namespace
}  // namespace hearth
