// Sectors that slices enter, against those that a point may see on the map.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "light/gather/plan_view.h"
#include "light/gather/slice.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "random_places.h"

namespace hearth {
namespace {

struct Counts {
  int entered = 0;
  int unseen = 0;  ///< sectors that no slice needs to be followed into
};

void compareAt(const test::RandomPlace& at, Counts& counts) {
  const Scene& scene = at.scene;
  const Vec3 point = at.point;
  Slice slice(scene, false);
  PlanView view(scene);
  view.lookFrom(point.xy(), at.sector, 0, nullptr);
  for (double angle = 3.7; angle < 360; angle += 7) {
    const Vec2 direction = directionAt(angle, 0).xy();
    SectorSet met;
    slice.areas({point, at.sector, kArrival}, direction, {-kStraightUp, kStraightUp}, &met);
    Box ahead;
    ahead.add(point.xy() + direction);
    const std::vector<SectorId> entered = met.sorted();
    counts.entered += static_cast<int>(entered.size());
    for (const SectorId other : entered)
      EXPECT_TRUE(view.maySee(other, ahead))
          << scene.level().name << ": " << scene[other].name << " from " << point.x << ' '
          << point.y << ' ' << point.z << " in " << scene[at.sector].name << ", angle " << angle;
    counts.unseen += static_cast<int>(std::ranges::count_if(
        scene.level().sectors, [&](const Sector& other) { return !view.maySee(other.id, ahead); }));
  }
}

TEST(PlanView, maySeeAllSectorsThatSlicesEnter) {
  Counts counts;
  test::forEachRandomPlace([](Level&) {},
                           [&](const test::RandomPlace& at) { compareAt(at, counts); });
  EXPECT_GT(counts.entered, 100'000);
  EXPECT_GT(counts.unseen, counts.entered);
}

}  // namespace
}  // namespace hearth
