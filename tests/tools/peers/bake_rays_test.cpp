// That another ray tracer is given the rays of the bake.

#include "peers/bake_rays.h"

#include <gtest/gtest.h>

#include "light/bakery.h"
#include "loaded.h"

namespace hearth {
namespace {

TEST(BakeRays, AreFreeWhereTheBakeFindsLight) {
  const LoadedLevel loaded = hearth::loaded("tests/levels/rooms.json");
  const Scene scene = loaded.scene();
  const auto tracer = EmbreeTracer::of(meshInLight(scene));
  ASSERT_TRUE(tracer) << tracer.error();
  BakeSettings settings = loaded.level.bake;
  settings.samples = 1;
  settings.softSamples = 0;
  LightCost bySamples;
  for (const LightCost& cost : bake(scene, settings, 2).lightCosts) bySamples += cost;
  const auto traced =
      BakeRays(scene, settings.texel, *tracer).traceAll(*tracer, 2, [] { return 0.0; });
  EXPECT_LT(traced.rays, bySamples.samples) << "no pairs where no light comes";
  EXPECT_GT(traced.rays, traced.free);
  // In edges of shadows single precision decides otherwise, and over walls under the sky, where no
  // link leads, there is nothing in Embree's way.
  EXPECT_NEAR(static_cast<double>(traced.free), static_cast<double>(bySamples.seenSamples),
              0.01 * static_cast<double>(bySamples.seenSamples));
}

}  // namespace
}  // namespace hearth
