// The level that shows why places are dark: in the middle of each shot of it is one that is.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "loaded.h"
#include "render/renderer.h"
#include "viewer/inspect/remedy.h"
#include "viewer/inspect/words.h"

namespace hearth {
namespace {

struct Spot {
  std::string shot;
  std::string surface;
  std::string reason;  ///< of the light of that room, which is the first
};

const Spot kSpots[] = {
    {"unlit-side", "wall 3 of pier/pier",
     "faces away: it is 2.2 m behind this surface; move it to this side, to smaller y"},
    {"step", "wall 2 of dais-top", "blocked by lower step at wall 4 of dais (7.5, 6, "},
    {"sidewall", "wall 1 of ramp-east",
     "blocked by sidewall of the sloped floor of ramp-way, at wall 1 of ramp-west (12, "},
    {"weak", "wall 4 of nook", "too weak here: 0."},
    {"in-plane", "wall 5 of bend",
     "in the plane of this surface: move it off the plane, to smaller x"},
};

/// What the middle of a shot shows.
TruthHit middleOf(const Scene& scene, const std::string& name) {
  const auto shot = std::ranges::find(scene.level().shots, name, &Shot::name);
  const Camera camera = cameraOf(*shot);
  const Projection projection = projectionFor(scene, camera);
  const Vec2 ray = projection.rayOf(camera.width / 2.0);
  return *trace(scene.level(), camera.sector, projection.eye(),
                {ray.x, ray.y, projection.raySlopeAt(camera.height / 2.0)}, RayKind::Look);
}

TEST(DarkSpots, AreNamedEachWithItsReason) {
  const LoadedLevel place = loaded("levels/dark-spots.json");
  const Level& level = place.level;
  const Scene scene = place.scene();
  const BakedLight light = bake(scene, level.bake, 2);
  for (const Spot& spot : kSpots) {
    const Inspection found = inspect(scene, light, level.bake, middleOf(scene, spot.shot));
    EXPECT_EQ(surfaceWords(level, found.place), spot.surface);
    EXPECT_TRUE(reasonWords(level, found.place, found.lights.at(0)).starts_with(spot.reason))
        << reasonWords(level, found.place, found.lights[0]);
    EXPECT_LT(found.sum.x, kVisibleLevel) << spot.shot;
    EXPECT_LE(found.lightmap->shown.x, kVisibleLevel) << spot.shot;
  }
}

TEST(DarkSpots, HaveOnlyTheLightOfTheirRoomNear) {
  const LoadedLevel place = loaded("levels/dark-spots.json");
  const Level& level = place.level;
  const Scene scene = place.scene();
  const BakedLight light = bake(scene, level.bake, 2);
  std::vector<std::size_t> near;
  for (const Spot& spot : kSpots)
    for (const auto& finding : inspect(scene, light, level.bake, middleOf(scene, spot.shot)).lights)
      if (finding.comesNear) near.push_back(finding.light);
  EXPECT_EQ(near, (std::vector<std::size_t>{5, 6, 7, 8, 9}));
}

/// The light that the first of a room's findings is about, which `change` mends by what it says.
template <typename Change>
double afterAdvice(const std::string& shot, Change&& change) {
  LoadedLevel place = loaded("levels/dark-spots.json");
  Level& level = place.level;
  const Scene scene = place.scene();
  const BakedLight light = bake(scene, level.bake, 2);
  const TruthHit spot = middleOf(scene, shot);
  const Inspection before = inspect(scene, light, level.bake, spot);
  LightSource& lamp = level.lights[before.lights.at(0).light];
  change(lamp, before.lights[0]);
  return brightest(inspect(scene, light, level.bake, spot).sum);
}

TEST(DarkSpots, AreLitByWhatTheirReasonsAdvise) {
  const auto lift = [](LightSource& lamp, const LightFinding& finding) {
    ASSERT_TRUE(finding.lift);
    lamp.position.z += *finding.lift;
  };
  EXPECT_GT(afterAdvice("step", lift), kClearLevel);
  EXPECT_GT(afterAdvice("sidewall", lift), kClearLevel);
  const double strengthened =
      afterAdvice("weak", [](LightSource& lamp, const LightFinding& finding) {
        lamp.falloff = *remedyFor(lamp, finding)->falloff;
      });
  EXPECT_GE(strengthened, kClearLevel);
  EXPECT_LT(strengthened, 1.1 * kClearLevel) << "no more than needed";
}

}  // namespace
}  // namespace hearth
