// The slopes in which slices find the sky, against single rays.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "light/gather/slice.h"
#include "light/rays/raytracer.h"
#include "light/sampling/sample_placement.h"
#include "load/load.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "random_levels/random_level.h"

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
void compareAt(const Scene& scene, const SamplePoint& at, Vec3 normal, Asked& asked) {
  constexpr bool kSolidMiddles = true;
  Slice slice(scene, kSolidMiddles);
  const Raytracer rays(scene, kSolidMiddles);
  const SectorId sector = scene[at.surface].sector;
  for (double angle = 3.7; angle < 360; angle += 17) {
    const std::vector<AreaInSlice> skies =
        slice.areas({at.target, sector, kArrival}, directionAt(angle, 0).xy(),
                    {-kStraightUp, kStraightUp}, nullptr);
    for (double pitch = -85; pitch < 90; pitch += 3.5) {
      const Vec3 direction = directionAt(angle, pitch);
      const double slope = tanDegrees(pitch);
      if (dot(direction, normal) < 1e-3 || isAtAnEnd(slope, skies)) continue;
      const bool isInRange = std::ranges::any_of(skies, [&](const AreaInSlice& sky) {
        return sky.slopes.from < slope && slope < sky.slopes.to;
      });
      const bool sees = rays.seesSky({at.target, sector}, direction);
      ++asked.rays;
      asked.seeSky += sees ? 1 : 0;
      EXPECT_EQ(isInRange, sees) << scene.level().name << ": from " << at.target.x << ' '
                                 << at.target.y << ' ' << at.target.z << " angle " << angle
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
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-slices-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  Asked asked;
  for (std::uint64_t seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    const RandomLevel random = makeRandomLevel(seed);
    ASSERT_TRUE(writeRandomLevel(folder, random));
    LoadResult result = loadLevel(folder / (random.name + ".json"));
    ASSERT_TRUE(result.loaded) << seed;
    giveTheSkyAlone(result.loaded->level);
    const Scene scene = result.loaded->scene();
    const LitSurfaces surfaces = makeLitSurfaces(scene, 0.25);
    for (const SurfaceId id : scene.shownSurfaces()) {
      const std::optional<LitSurface>& lit = surfaces[id.index()];
      if (!lit) continue;
      const TexelRect rect = lit->texels;
      const SamplePoint at =
          SamplePlacement(surfaces, id)
              .place({rect.i0 + rect.width / 2 + 0.5, rect.j0 + rect.height / 3 + 0.5});
      compareAt(scene, at, surfaces[at.surface.index()]->normal, asked);
    }
  }
  std::filesystem::remove_all(folder);
  EXPECT_GT(asked.rays, 1'000'000);
  EXPECT_GT(asked.seeSky, asked.rays / 20);
}

}  // namespace
}  // namespace hearth
