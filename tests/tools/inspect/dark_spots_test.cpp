// The level that shows why places are dark: in the middle of each shot of it is one that is.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "hearth/inspect/words.h"
#include "loaded.h"
#include "render/renderer.h"

namespace hearth {
namespace {

struct Spot {
  std::string shot;
  std::string surface;
  std::string reason;  ///< of the light of that room, which is the first
};

const Spot kSpots[] = {
    {"unlit-side", "solid wall of pier/pier, wall 3",
     "faces away: the light is behind this surface"},
    {"step", "solid wall of dais-top, wall 2", "blocked by lower step of dais, wall 4 at 7.5,6,"},
    {"sidewall", "solid wall of ramp-east, wall 1",
     "blocked by floor sidewall of ramp-way, seen through ramp-west, wall 1 at 12,"},
    {"weak", "solid wall of nook, wall 4", "too weak here: 0."},
    {"in-plane", "solid wall of bend, wall 5", "in the plane of the surface"},
};

TEST(DarkSpots, AreNamedEachWithItsReason) {
  const LoadedLevel place = loaded("levels/dark-spots.json");
  const Level& level = place.level;
  const BakedLight light = bake(level, level.bake, 2);
  for (const Spot& spot : kSpots) {
    const auto shot = std::ranges::find(level.shots, spot.shot, &Shot::name);
    ASSERT_NE(shot, level.shots.end()) << spot.shot;
    const Camera camera = cameraOf(*shot);
    const Projection projection = projectionFor(level, camera);
    const Vec2 ray = projection.rayOf(camera.width / 2.0);
    const auto hit = trace(level, camera.sector, projection.eye(),
                           {ray.x, ray.y, projection.climbOf(camera.height / 2.0)}, RayKind::Look);
    const Inspection found = inspect(level, light, level.bake, *hit);
    EXPECT_EQ(surfaceWords(level, found.place), spot.surface);
    EXPECT_TRUE(reasonWords(level, found.lights.at(0)).starts_with(spot.reason))
        << reasonWords(level, found.lights[0]);
    EXPECT_LT(found.sum.x, kVisibleLevel) << spot.shot;
    EXPECT_LE(found.lightmap->shown.x, kVisibleLevel) << spot.shot;
  }
}

}  // namespace
}  // namespace hearth
