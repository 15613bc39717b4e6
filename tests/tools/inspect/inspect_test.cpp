// What is said of a place: held against the definition of light, and against pictures.

#include "viewer/inspect/inspect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "loaded.h"
#include "render/renderer.h"
#include "support/in_tree.h"
#include "support/level_text.h"
#include "truth/truth_light.h"
#include "viewer/inspect/words.h"

namespace hearth {
namespace {

const std::string kSolid = "{'texture':'#808080'}";

/// What a look from `eye` in the sector along `direction` meets.
TruthHit lookedAt(const Level& level, const std::string& sector, Vec3 eye, Vec3 direction) {
  return *trace(level, sectorNamed(level, sector), eye, direction, RayKind::Look);
}

Inspection inspected(const Scene& scene, const TruthHit& place) {
  const BakeSettings& settings = scene.level().bake;
  return inspect(scene, bake(scene, settings, 1), settings, place);
}

/// The only finding of a level of one light, in words.
std::string reasonAt(const LoadedLevel& loaded, const std::string& sector, Vec3 eye,
                     Vec3 direction) {
  const Level& level = loaded.level;
  const Inspection found = inspected(loaded.scene(), lookedAt(level, sector, eye, direction));
  EXPECT_EQ(found.lights.size(), 1);
  return reasonWords(level, found.place, found.lights.at(0));
}

/// A room of 10 x 4 x 3 m whose eastern half is another sector.
LoadedLevel halves(const std::string& east, const std::string& lights, double eastFloor = 0,
                   const std::string& more = "") {
  const std::string next = ",'lower':'#303030','upper':'#303030'}";
  return test::levelFrom(
      "{'light':0,'sectors':{" +
          test::sectorText(
              "west", "0,0, 5,0, 5,4, 0,4", 0, 3,
              "[" + kSolid + ",{'next':'east'" + east + next + "," + kSolid + "," + kSolid + "]") +
          "," +
          test::sectorText(
              "east", "5,0, 10,0, 10,4, 5,4", eastFloor, 3,
              "[" + kSolid + "," + kSolid + "," + kSolid + ",{'next':'west'" + next + "]", more) +
          "}}",
      lights);
}

std::string lamp(double x, double y, double z, const std::string& more = "") {
  return "[{'x':" + std::to_string(x) + ",'y':" + std::to_string(y) + ",'z':" + std::to_string(z) +
         more + "}]";
}

TEST(Inspect, namesTheUnlitSideOfAWall) {
  // The lamp stands in the next room, behind the step whose other side is looked at.
  const LoadedLevel loaded = halves("", lamp(8, 2, 2.5), 1.5);
  EXPECT_EQ(reasonAt(loaded, "west", {1, 2, 1}, {1, 0, 0}),
            "faces away: it is 3 m behind this surface; move it to this side, to smaller x");
}

TEST(Inspect, namesTheStepThatBlocks) {
  const LoadedLevel loaded = halves("", lamp(9, 2, 1.75), 1.5);
  EXPECT_EQ(reasonAt(loaded, "west", {2, 2, 1}, {0, 0, -1}),
            "blocked by floor of east (8, 2, 1.5): move it to where nothing is between");
  const LoadedLevel other = halves("", lamp(4, 2, 0.5), 1.5);
  EXPECT_EQ(reasonAt(other, "east", {8, 2, 2}, {0, 0, 1}),
            "blocked by lower step at wall 1 of west (5, 2, 1.125): raise it 0.5 m or more");
}

TEST(Inspect, namesTheSidewallThatBlocks) {
  const LoadedLevel loaded =
      halves("", lamp(2, 2, 0.5), 0, ",'slopeFloor':{'z':[2,0,0,2],'sidewall':'#808080'}");
  EXPECT_EQ(reasonAt(loaded, "east", {9.9, 2, 1}, {1, 0, -0.1}),
            "blocked by sidewall of the sloped floor of east, at wall 1 of west (5, 2, 0.684): "
            "raise it 2.2 m or more");
}

TEST(Inspect, namesTheHangingTextureThatBlocksAndLetsLightThroughItsHoles) {
  LoadedLevel loaded = halves(",'middle':'#808080 4,3'", lamp(2, 2, 1.5));
  EXPECT_EQ(reasonAt(loaded, "east", {8, 2, 1.5}, {1, 0, 0}),
            "blocked by middle texture at wall 1 of west (5, 2, 1.5): move it to where nothing is "
            "between");
  TexelHoles holes(1, 1);
  holes.setHole(0, 0);
  loaded.level.holes.assign(loaded.level.textures.size(), holes);
  EXPECT_EQ(reasonAt(loaded, "east", {8, 2, 1.5}, {1, 0, 0}), "");
}

TEST(Inspect, namesALightThatIsTooWeakAndTellsHowWeak) {
  const LoadedLevel loaded = halves("", lamp(2, 2, 1.5, ",'intensity':3,'falloff':1"));
  EXPECT_EQ(reasonAt(loaded, "west", {2.5, 2, 1.5}, {1, 0, 0}),
            "too weak here: 0.33 of 255 at 8 m; intensity 580 instead of 3 would give 64");
  const Level& level = loaded.level;
  const TruthHit place = lookedAt(level, "west", {2.5, 2, 1.5}, {1, 0, 0});
  EXPECT_NEAR(inspected(loaded.scene(), place).sum.x, 1.0 / 3, 1e-12) << "which is something";
  BakeSettings cut = level.bake;
  cut.cutOff = 1;
  EXPECT_EQ(inspect(loaded.scene(), bake(loaded.scene(), cut, 1), cut, place).sum, Vec3{});
}

TEST(Inspect, tellsWhatWouldMakeAFaintLightEnough) {
  const LoadedLevel loaded = halves("", lamp(2, 2, 1.5, ",'intensity':30,'falloff':1"));
  EXPECT_EQ(reasonAt(loaded, "west", {2.5, 2, 1.5}, {1, 0, 0}),
            "too weak here: 3.33 of 255 at 8 m; intensity 580 instead of 30 would give 64");
  const LoadedLevel brighter = halves("", lamp(2, 2, 1.5, ",'intensity':160,'falloff':1"));
  EXPECT_EQ(reasonAt(brighter, "west", {2.5, 2, 1.5}, {1, 0, 0}), "");
}

TEST(Inspect, namesASpotThatShinesElsewhere) {
  const LoadedLevel loaded = halves("", lamp(2, 2, 1.5, ",'spot':{'pitch':-90,'outer':30}"));
  EXPECT_EQ(reasonAt(loaded, "west", {2.5, 2, 1.5}, {1, 0, 0}),
            "outside its spot, which ends 30 degrees from its direction: turn it, or give it a "
            "larger \"outer\"");
}

TEST(Inspect, tellsWhatWouldMakeASpotEnoughWhereItsLightEnds) {
  // Half of it goes at a right angle to its direction.
  const LoadedLevel loaded =
      halves("", lamp(2, 2, 1.5, ",'intensity':6,'spot':{'angle':90,'outer':180}"));
  EXPECT_EQ(reasonAt(loaded, "west", {2.5, 2, 1.5}, {1, 0, 0}),
            "too weak here: 3 of 255 at 8 m; intensity 130 instead of 6 would give 64");
}

/// A yard with a roofed half in the west, where the ceiling is as high as the sky.
LoadedLevel underHalfASky(const std::string& sun, const std::string& bake = "{}") {
  const std::string level =
      "{'light':0,'textures':'" + test::inTree("textures").string() + "','sectors':{" +
      test::sectorText("west", "0,0, 5,0, 5,4, 0,4", 0, 3,
                       "[" + kSolid + ",{'next':'east'}," + kSolid + "," + kSolid + "]") +
      ",'east':{'floor':{'texture':'#808080'},"
      "'ceiling':{'z':3,'texture':'sky','parallax':true},'loops':{'border':{"
      "'v':[5,0, 10,0, 10,4, 5,4],'walls':[" +
      kSolid + "," + kSolid + "," + kSolid + ",{'next':'west'}]}}}}}";
  return test::levelFrom(level, "{'lights':[],'suns':[" + sun + "],'bake':" + bake + "}");
}

TEST(Inspect, tellsWhatASunGives) {
  const LoadedLevel loaded = underHalfASky("{'angle':0,'pitch':60,'intensity':200}");
  const TruthHit lit = lookedAt(loaded.level, "east", {7, 2, 1}, {0, 0, -1});
  const Inspection found = inspected(loaded.scene(), lit);
  EXPECT_EQ(found.lights.at(0).adds.x, 200);
  EXPECT_EQ(found.sum.x, 200);
  EXPECT_EQ(reasonWords(loaded.level, found.place, found.lights.at(0)), "");
}

LoadedLevel underHalfALitSky() {
  LoadedLevel loaded = underHalfASky("");
  LightSource sky;
  sky.isSky = true;
  sky.intensity = 200;
  loaded.level.lights.push_back(sky);
  return loaded;
}

TEST(Inspect, tellsHowMuchOfTheSkyArrives) {
  const LoadedLevel loaded = underHalfALitSky();
  const TruthHit lit = lookedAt(loaded.level, "east", {7, 2, 1}, {0, 0, -1});
  const Inspection found = inspected(loaded.scene(), lit);
  EXPECT_NEAR(found.sum.x, found.lightmap->shown.x, 1.5);
  EXPECT_EQ(reasonWords(loaded.level, found.place, found.lights.at(0)),
            "40 % of what level ground in the open gets");
  EXPECT_EQ(reasonAt(loaded, "west", {1, 2, 1}, {0, 0, 1}),
            "not seen: no straight way leads from here to the sky");
}

/// A closed room of 8 x 6 x 3 m, grey but for its ceiling.
LoadedLevel hallUnder(const std::string& ceiling, const std::string& lights) {
  return test::levelFrom(
      "{'light':0,'sectors':{'hall':{'floor':{'texture':'#808080'},"
      "'ceiling':{'z':3,'texture':'" +
          ceiling +
          "'},'loops':{'border':{'v':[0,0, 8,0, 8,6, 0,6],"
          "'walls':" +
          kSolid + "}}}}}",
      lights);
}

TEST(Inspect, tellsHowMuchOfAnEmitterArrives) {
  const LoadedLevel hall =
      hallUnder("#ffffff", "{'lights':[],'emit':{'#ffffff':{'intensity':200},'#00ff00':{}}}");
  const TruthHit lit = lookedAt(hall.level, "hall", {4, 3, 1}, {0, 0, -1});
  const Inspection found = inspected(hall.scene(), lit);
  EXPECT_NEAR(found.sum.x, found.lightmap->shown.x, 1.5);
  EXPECT_EQ(reasonWords(hall.level, found.place, found.lights.at(0)),
            "62 % of what a place gets that sees nothing else");
  EXPECT_EQ(reasonWords(hall.level, found.place, found.lights.at(1)),
            "not seen: no straight way leads from here to \"#00ff00\"");
  const TruthHit shining = lookedAt(hall.level, "hall", {4, 3, 1}, {0, 0, 1});
  EXPECT_EQ(brightnessWords(hall.level, inspected(hall.scene(), shining)),
            "lit, 200 of 255: no light gives it anything; its texture shines with 200");
}

/// A closed room of one grey that sees its light everywhere has 60 (1 + r + r^2 + r^3).
TEST(Inspect, tellsHowMuchLightBounces) {
  const LoadedLevel hall =
      hallUnder("#808080", "{'lights':[{'x':4,'y':3,'z':2,'intensity':60}],'bake':{'bounces':3}}");
  const TruthHit lit = lookedAt(hall.level, "hall", {3, 3, 1}, {0, 0, -1});
  const Inspection found = inspected(hall.scene(), lit);
  const double r = 128.0 / 255;
  EXPECT_NEAR(found.bounced.x, 60 * (r + r * r + r * r * r), 1);
  EXPECT_EQ(found.sum.x, 60);
  EXPECT_EQ(brightnessWords(hall.level, found), "dim, 113 of 255: lights give 113");
}

TEST(Inspect, namesWhatHidesASun) {
  const LoadedLevel loaded = underHalfASky("{'angle':0,'pitch':60,'intensity':200}");
  EXPECT_EQ(
      reasonAt(loaded, "west", {1, 2, 1}, {0, 0, -1}),
      "blocked by ceiling of west (2.732, 2, 3): open a way to the sky there, or turn the sun");
}

TEST(Inspect, namesTheSideOfASun) {
  const LoadedLevel loaded = underHalfASky("{'angle':0,'pitch':60}");
  EXPECT_EQ(reasonAt(loaded, "east", {7, 2, 1}, {1, 0, 0}),
            "faces away: this surface looks to the other side of the sky");
  EXPECT_EQ(reasonAt(loaded, "east", {7, 2, 1}, {0, 1, 0}),
            "in the plane of this surface, which it only grazes: turn the sun");
}

TEST(Inspect, namesTheSideOfASunOfWhichAPartIsInFrontIfTheCosineLeavesNothing) {
  // The middle of its disc is 5 degrees behind the wall, its rim 5 degrees before it.
  const LoadedLevel loaded = underHalfASky("{'angle':-5,'pitch':20,'size':20}", "{'lambert':true}");
  EXPECT_EQ(reasonAt(loaded, "east", {7, 2, 2.5}, {0, -1, 0}),
            "faces away: this surface looks to the other side of the sky");
}

TEST(Inspect, tellsHowStrongASunMustBe) {
  const LoadedLevel loaded = underHalfASky("{'angle':0,'pitch':60,'intensity':3}");
  EXPECT_EQ(reasonAt(loaded, "east", {7, 2, 1}, {0, 0, -1}),
            "too weak here: 3 of 255; intensity 64 instead of 3 would give 64");
}

TEST(Inspect, namesALightInThePlaneOfTheSurface) {
  const LoadedLevel loaded = halves("", lamp(5, 2, 1.5), 1);
  EXPECT_EQ(reasonAt(loaded, "west", {1, 2, 0.5}, {1, 0, 0}),
            "in the plane of this surface: move it off the plane, to smaller x");
}

TEST(Inspect, namesALightWhoseWayLeadsElsewhere) {
  // Two rooms at one place, that know nothing of each other.
  const LoadedLevel loaded = test::levelFrom(
      "{'light':0,'sectors':{" + test::sectorText("here", "0,0, 9,0, 9,9, 0,9", 0, 3) + "," +
          test::sectorText("there", "0,0, 9,0, 9,5, 0,5", 0, 4) + "}}",
      "[{'x':1,'y':1,'z':3.5}]");
  EXPECT_EQ(reasonAt(loaded, "here", {4, 4, 1}, {0, 0.001, 1}),
            "faces away: it is 0.5 m behind this surface; move it to this side, down");
  const LoadedLevel inside = test::levelFrom(
      "{'light':0,'sectors':{" + test::sectorText("here", "0,0, 5,0, 5,5, 0,5", 0, 3) + "," +
          test::sectorText("there", "-9,-9, 9,-9, 9,9, -9,9", -1, 4) + "}}",
      "[{'x':1,'y':1,'z':2,'sector':'there'}]");
  EXPECT_EQ(reasonAt(inside, "here", {4, 2, 1}, {1, 0, 0}),
            "not reached: it shines in a part of the level from which no straight way leads here");
}

TEST(Inspect, tellsWhichFractionOfABallIsSeen) {
  const LoadedLevel loaded = halves("", lamp(8, 2, 1.5, ",'radius':0.4"), 1.5);
  const Level& level = loaded.level;
  const Inspection found =
      inspected(loaded.scene(), lookedAt(level, "west", {1, 2, 1.5}, {-1, 0, 0}));
  EXPECT_NEAR(found.lights.at(0).seenFraction, 0.5, 0.02) << "the half above the floor";
  EXPECT_TRUE(reasonWords(level, found.place, found.lights[0]).ends_with(" % of it seen"));
  EXPECT_NEAR(found.sum.x, 255 * found.lights[0].seenFraction, 1e-9);
}

TEST(Inspect, saysNothingOfSkies) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light':0,'sectors':{'yard':{'floor':{'texture':'#808080'},"
      "'ceiling':{'z':3,'texture':'#808080','parallax':true},"
      "'loops':{'border':{'v':[0,0, 4,0, 4,4, 0,4],'walls':{'texture':'#808080'}}}}}}",
      lamp(1, 1, 1));
  const Inspection found =
      inspected(loaded.scene(), lookedAt(loaded.level, "yard", {2, 2, 1}, {0, 0, 1}));
  EXPECT_FALSE(found.lightmap);
  EXPECT_TRUE(found.lights.empty());
}

TEST(Inspect, hasTheBrightestFirstAndThenWhatWouldBe) {
  const LoadedLevel loaded =
      halves("",
             "[{'x':1,'y':2,'z':2,'intensity':20},{'x':9,'y':2,'z':0.5,'intensity':90},"
             "{'x':1,'y':1,'z':2,'intensity':50,'color':'#ff0000'},{'x':9,'y':1,'z':0.5}]");
  const Level& level = loaded.level;
  const TruthHit wall = lookedAt(level, "east", {6, 2, 1}, {1, 0, 0});
  std::vector<std::size_t> order;
  for (const LightFinding& finding : inspected(loaded.scene(), wall).lights)
    order.push_back(finding.light);
  EXPECT_EQ(order, (std::vector<std::size_t>{3, 1, 0, 2}));
}

// --- Against the definition, and against pictures ------------------------------------------------

/// Calls `check(hit, column, row)` for some pixels of all shots of a level.
template <typename Check>
void forPixelsOfShots(const Scene& scene, Check&& check) {
  for (const Shot& shot : scene.level().shots) {
    Camera camera = cameraOf(shot);
    camera.width = 11;
    camera.height = 7;
    const Projection projection = projectionFor(scene, camera);
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column) {
        const Vec2 ray = projection.rayOf(column + 0.5);
        const auto hit = trace(scene.level(), camera.sector, projection.eye(),
                               {ray.x, ray.y, projection.raySlopeAt(row + 0.5)}, RayKind::Look);
        check(*hit, camera, column, row);
      }
  }
}

/// Without areas, whose light is defined by an integral.
void expectAsDefined(const std::string& path) {
  LoadedLevel place = loaded(path);
  std::erase_if(place.level.lights, [](const LightSource& light) { return light.isArea(); });
  const Level& level = place.level;
  const Scene scene = place.scene();
  const TruthLight truth(level, kInspectedBallPoints);
  const BakedLight light = bake(scene, level.bake, 2);
  int lit = 0;
  forPixelsOfShots(scene, [&](const TruthHit& hit, const Camera&, int, int) {
    if (isSky(hit.kind)) return;
    const Inspection found = inspect(scene, light, level.bake, hit);
    const Vec3 sum = truth.at(hit);
    ASSERT_NEAR(length(found.sum - sum), 0, 1e-9) << surfaceWords(level, hit);
    ASSERT_EQ(found.lights.size(), level.lights.size());
    lit += sum.x > 1 ? 1 : 0;
  });
  EXPECT_GT(lit, 100) << path;
}

TEST(Inspect, addsUpToTheLightAsDefinedWithSlopesAndStacksAndFlatPortals) {
  expectAsDefined("levels/tutorial.json");
}

TEST(Inspect, addsUpToTheLightAsDefinedBehindGrilles) { expectAsDefined("levels/gaol.json"); }

TEST(Inspect, hasOfTheLightmapWhatPicturesHave) {
  for (const char* path : {"levels/tutorial.json", "levels/gaol.json"}) {
    const LoadedLevel place = loaded(path);
    const Level& level = place.level;
    const Scene scene = place.scene();
    const BakedLight light = bake(scene, level.bake, 2);
    const Renderer renderer(scene, place.textures, light);
    Image picture;
    forPixelsOfShots(scene, [&](const TruthHit& hit, const Camera& camera, int column, int row) {
      if (column == 0 && row == 0) picture = renderer.draw(camera, Channel::Light);
      if (isSky(hit.kind)) return;
      const auto found = inspect(scene, light, level.bake, hit).lightmap;
      ASSERT_TRUE(found) << surfaceWords(level, hit);
      const Rgb pixel = picture.at(column, row);
      ASSERT_NEAR(found->shown.x, pixel.r, 1) << surfaceWords(level, hit);
      ASSERT_NEAR(found->shown.z, pixel.b, 1) << surfaceWords(level, hit);
      ASSERT_LT(found->column, found->columns);
      ASSERT_LT(found->row, found->rows);
    });
  }
}

}  // namespace
}  // namespace hearth
