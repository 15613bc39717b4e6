#include "same_bakes.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "light/saved_bake.h"

namespace hearth::test {

void expectSame(const Scene& scene, const BakedLight& rebaked, const BakedLight& baked) {
  EXPECT_EQ(encodeBake(scene, rebaked, scene.level().bake.texel, ""),
            encodeBake(scene, baked, scene.level().bake.texel, ""));
  EXPECT_EQ(rebaked.lightCosts, baked.lightCosts);
  ASSERT_EQ(rebaked.surfaceCosts.size(), baked.surfaceCosts.size());
  for (std::size_t i = 0; i < baked.surfaceCosts.size(); ++i) {
    EXPECT_EQ(rebaked.surfaceCosts[i].facingLights, baked.surfaceCosts[i].facingLights);
    EXPECT_EQ(rebaked.surfaceCosts[i].rays, baked.surfaceCosts[i].rays);
  }
}

}  // namespace hearth::test
