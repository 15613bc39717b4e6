// The slopes in which slices find the sky, against single rays.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "light/gather/slice.h"
#include "light/rays/raytracer.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "random_places.h"

namespace hearth {
namespace {

struct Asked {
  int rays = 0;
  int seeSky = 0;
};

/// Where a slice begins or ends a range, rounding may decide for a ray.
bool isAtAnEnd(double slope, const std::vector<AreaInSlice>& skies) {
  constexpr double kNear = 1e-6;
  return std::ranges::any_of(skies, [&](const AreaInSlice& sky) {
    return std::abs(slope - sky.slopes.from) < kNear * (1 + std::abs(slope)) ||
           std::abs(slope - sky.slopes.to) < kNear * (1 + std::abs(slope));
  });
}

/// Masked textures are solid: of these slices ask only some points.
void compareAt(const test::RandomPlace& at, Asked& asked) {
  constexpr bool kSolidMiddles = true;
  Slice slice(at.scene, kSolidMiddles);
  const Raytracer rays(at.scene, kSolidMiddles);
  for (double angle = 3.7; angle < 360; angle += 17) {
    const std::vector<AreaInSlice> skies =
        slice.areas({at.point, at.sector, kArrival}, directionAt(angle, 0).xy(),
                    {-kStraightUp, kStraightUp}, nullptr);
    for (double pitch = -85; pitch < 90; pitch += 3.5) {
      const Vec3 direction = directionAt(angle, pitch);
      const double slope = tanDegrees(pitch);
      if (dot(direction, at.normal) < 1e-3 || isAtAnEnd(slope, skies)) continue;
      const bool isInRange = std::ranges::any_of(skies, [&](const AreaInSlice& sky) {
        return sky.slopes.from < slope && slope < sky.slopes.to;
      });
      const bool sees = rays.seesSky({at.point, at.sector}, direction);
      ++asked.rays;
      asked.seeSky += sees ? 1 : 0;
      EXPECT_EQ(isInRange, sees) << at.scene.level().name << ": from " << at.point.x << ' '
                                 << at.point.y << ' ' << at.point.z << " angle " << angle
                                 << " pitch " << pitch;
    }
  }
}

void giveTheSkyAlone(Level& level) {
  LightSource sky;
  sky.isSky = true;
  level.lights = {sky};
}

TEST(Slice, findsTheSkyWhereRaysDo) {
  Asked asked;
  test::forEachRandomPlace(giveTheSkyAlone,
                           [&](const test::RandomPlace& at) { compareAt(at, asked); });
  EXPECT_GT(asked.rays, 1'000'000);
  EXPECT_GT(asked.seeSky, asked.rays / 20);
}

}  // namespace
}  // namespace hearth
