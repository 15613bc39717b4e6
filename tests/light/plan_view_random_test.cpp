// Sectors that slices enter, against those that a point may see on the map.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "light/gather/plan_view.h"
#include "light/gather/slice.h"
#include "light/sampling/sample_placement.h"
#include "load/load.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "random_levels/random_level.h"

namespace hearth {
namespace {

struct Counts {
  int entered = 0;
  int unseen = 0;  ///< sectors that no slice needs to be followed into
};

void compareAt(const Scene& scene, Vec3 point, SectorId sector, Counts& counts) {
  Slice slice(scene, false);
  PlanView view(scene);
  view.lookFrom(point.xy(), sector, 0, nullptr);
  for (double angle = 3.7; angle < 360; angle += 7) {
    const Vec2 direction = directionAt(angle, 0).xy();
    SectorSet met;
    slice.areas({point, sector, kArrival}, direction, {-kStraightUp, kStraightUp}, &met);
    Box ahead;
    ahead.add(point.xy() + direction);
    const std::vector<SectorId> entered = met.sorted();
    counts.entered += static_cast<int>(entered.size());
    for (const SectorId other : entered)
      EXPECT_TRUE(view.maySee(other, ahead))
          << scene.level().name << ": " << scene[other].name << " from " << point.x << ' '
          << point.y << ' ' << point.z << " in " << scene[sector].name << ", angle " << angle;
    counts.unseen += static_cast<int>(std::ranges::count_if(
        scene.level().sectors, [&](const Sector& other) { return !view.maySee(other.id, ahead); }));
  }
}

TEST(PlanView, maySeeAllSectorsThatSlicesEnter) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-plan-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  Counts counts;
  for (std::uint64_t seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    const RandomLevel random = makeRandomLevel(seed);
    ASSERT_TRUE(writeRandomLevel(folder, random));
    const LoadResult result = loadLevel(folder / (random.name + ".json"));
    ASSERT_TRUE(result.loaded) << seed;
    const Scene scene = result.loaded->scene();
    const LitSurfaces surfaces = makeLitSurfaces(scene, 0.25);
    for (const SurfaceId id : scene.shownSurfaces()) {
      const std::optional<LitSurface>& lit = surfaces[id.index()];
      if (!lit) continue;
      const TexelRect rect = lit->texels;
      const SamplePoint at =
          SamplePlacement(surfaces, id)
              .place({rect.i0 + rect.width / 2 + 0.5, rect.j0 + rect.height / 3 + 0.5});
      compareAt(scene, at.target, scene[at.surface].sector, counts);
    }
  }
  std::filesystem::remove_all(folder);
  EXPECT_GT(counts.entered, 100'000);
  EXPECT_GT(counts.unseen, counts.entered);
}

}  // namespace
}  // namespace hearth
