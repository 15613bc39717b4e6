// Which light is baked for a single picture.

#include <gtest/gtest.h>

#include "inputs/inputs.h"
#include "load/load.h"
#include "render/renderer.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

class LightInView : public testing::Test {
 protected:
  LightInView() { options_.set(Option::NoCache, ""); }

  BakedLight light(const Shot& shot) const {
    return lightInView(loaded_.scene(), cameraOf(shot), options_).value();
  }
  Image picture(const Shot& shot) const {
    const BakedLight baked = light(shot);
    return Renderer(loaded_.scene(), loaded_.textures, baked)
        .draw(cameraOf(shot), lightModeFrom(options_));
  }

  LoadedLevel loaded_ = loadLevel(test::inTree("levels/gaol.json")).loaded.value();
  OptionValues options_;
};

TEST_F(LightInView, IsNotBakedForAPictureThatShowsNone) {
  options_.set(Option::Light, "none");
  const BakedLight whole = bake(loaded_.scene(), loaded_.level.bake, 2);
  for (const Shot& shot : loaded_.level.shots) {
    const BakedLight none = light(shot);
    EXPECT_EQ(none.stats.rays, 0) << shot.name;
    EXPECT_EQ(none.stats.litSurfaces, 0U) << shot.name;
    EXPECT_EQ(
        picture(shot),
        Renderer(loaded_.scene(), loaded_.textures, whole).draw(cameraOf(shot), LightMode::None))
        << shot.name;
  }
}

TEST_F(LightInView, IsBakedForAPictureThatShowsLightAlone) {
  options_.set(Option::Light, "only");
  for (const Shot& shot : loaded_.level.shots) EXPECT_GT(light(shot).stats.rays, 0) << shot.name;
}

}  // namespace
}  // namespace hearth
