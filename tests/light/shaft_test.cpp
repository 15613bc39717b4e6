// Whether shafts know what rays would say.

#include "light/rays/shaft.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "both_bakes.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using test::BothCosts;

TEST(Shafts, giveTheBytesOfRaysInRandomLevels) { test::expectSameRandomBakes(1, 13); }

TEST(Shafts, giveTheBytesOfRaysBehindAGrille) {
  const std::string solid = "{'texture':'#808080'}";
  const auto wallsWith = [&](const std::string& west, const std::string& east) {
    return "[" + solid + "," + east + "," + solid + "," + west + "]";
  };
  LoadedLevel loaded = test::levelFrom(
      "{'light':0,'sectors':{" +
          test::sectorText("cell", "0,0, 4,0, 4,4, 0,4", 0, 3,
                           wallsWith(solid, "{'next':'hall','middle':'#808080 0.5,2'}")) +
          "," +
          test::sectorText("hall", "4,0, 8,0, 8,4, 4,4", 0, 3,
                           wallsWith("{'next':'cell','middle':'#808080 0.7,1'}", solid)) +
          "}}",
      "[{'x':6,'y':2,'z':1.5,'falloff':0.1},{'x':7,'y':1,'z':2,'radius':0.2}]");
  TexelHoles holes(2, 2);
  for (const int i : {0, 1}) holes.setHole(i, 1 - i);
  loaded.level.holes.assign(loaded.level.textures.size(), holes);
  BakeSettings settings = loaded.level.bake;
  for (const bool areSolid : {false, true}) {
    settings.solidMaskedMiddles = areSolid;
    BothCosts costs;
    test::expectSameBakes(loaded.scene(), settings, "grille", costs);
  }
}

/// Boxes before, behind and in an opening; one of "east" that reaches through a wall into "west",
/// and one in a sector that overlaps both: there these stop no light.
TEST(Shafts, giveTheBytesOfRaysAmongMeshes) {
  const std::string solid = "{'texture':'#808080'}";
  const auto opening = [](const std::string& next) {
    return "{'texture':'#808080','next':'" + next + "'}";
  };
  const LoadedLevel loaded = test::levelFrom(
      "{'things':[{'mesh':'box.obj','x':2,'y':1.3,'sector':'west'},"
      "{'mesh':'box.obj','x':4.1,'y':2.2,'z':1,'scale':0.5,'sector':'east'},"
      "{'mesh':'box.obj','x':4.1,'y':0.9,'z':1.5,'scale':0.5,'sector':'east'},"
      "{'mesh':'box.obj','x':6.5,'y':3,'scale':0.7,'sector':'east'},"
      "{'mesh':'box.obj','x':3,'y':3,'z':1.5,'sector':'apart'}],'sectors':{" +
          test::sectorText("west", "0,0, 4,0, 4,1.5, 4,2.5, 4,4, 0,4", 0, 3,
                           "[" + solid + "," + solid + "," + opening("east") + "," + solid + "," +
                               solid + "," + solid + "]") +
          "," +
          test::sectorText("east", "4,0, 8,0, 8,4, 4,4, 4,2.5, 4,1.5", 0.2, 2.5,
                           "[" + solid + "," + solid + "," + solid + "," + solid + "," +
                               opening("west") + "," + solid + "]") +
          "," + test::sectorText("apart", "0,0, 8,0, 8,4, 0,4", 0, 3) + "}}",
      "[{'x':1,'y':3,'z':2.5,'radius':0.3,'sector':'west'},"
      "{'x':3.7,'y':0.4,'z':2,'radius':0.1,'sector':'west'},"
      "{'x':7,'y':0.7,'z':1.5,'radius':0.1,'sector':'east'},"
      "{'x':5,'y':1,'z':2,'radius':0.2,'sector':'apart'}]",
      {{"box.obj", test::kBoxModel}});
  for (const std::optional<int> samples : {std::optional(1), std::optional<int>()}) {
    BakeSettings settings = loaded.level.bake;
    settings.texel = 0.15;
    settings.samples = samples;
    BothCosts costs;
    test::expectSameBakes(loaded.scene(), settings, "meshes", costs);
    EXPECT_LT(costs.byShafts.rays, costs.byRays.rays);
    EXPECT_GT(costs.byShafts.rays, 1000);
  }
}

/// A square on the floor of a room, seen from a light at `from`.
TargetVisibility outcomeOf(const Scene& scene, Vec3 from, double radius, Vec2 least, Vec2 most) {
  ShaftTargets targets;
  targets.box.normal = {0, 0, 1};
  for (const Vec2 p : {least, Vec2{most.x, least.y}, most, Vec2{least.x, most.y}})
    targets.box.storage[targets.box.count++] = {p.x, p.y, 0};
  const SectorId room(0);
  targets.sectors = {&room, 1};
  return Shaft(scene).follow({from, radius, {room}, true}, targets, nullptr);
}

/// A room of 10 x 10 m with a square pillar in its middle.
LoadedLevel pillarRoom() {
  return test::levelFrom(
      "{'light': 0, 'sectors': {'room': {'floor': {'z': 0, 'texture': '#808080'},"
      "'ceiling': {'z': 3, 'texture': '#808080'}, 'loops': {"
      "'border': {'v': [0,0, 10,0, 10,10, 0,10], 'walls': {'texture': '#808080'}},"
      "'pillar': {'v': [4,4, 4,6, 6,6, 6,4], 'walls': {'texture': '#808080'}}}}}}");
}

TEST(Shaft, isLitBesideAPillarDarkBehindItAndUnknownAtTheShadowsEdge) {
  const LoadedLevel loaded = pillarRoom();
  for (const double radius : {0.0, 0.2}) {
    const auto outcome = [&](Vec2 least, Vec2 most) {
      return outcomeOf(loaded.scene(), {1, 5, 2}, radius, least, most);
    };
    EXPECT_EQ(outcome({1, 1}, {3, 2}), TargetVisibility::Lit);
    EXPECT_EQ(outcome({7, 1e-6}, {9, 0.5}), TargetVisibility::Lit) << "up to the wall";
    EXPECT_EQ(outcome({7, 4.5}, {8, 5.5}), TargetVisibility::Dark);
    EXPECT_EQ(outcome({7, 2}, {8, 5}), TargetVisibility::Unknown);
  }
}

TEST(Shaft, isDarkBehindTheEdgeOfAPillarThatTwoOfItsSidesHide) {
  const LoadedLevel loaded = pillarRoom();
  EXPECT_EQ(outcomeOf(loaded.scene(), {1, 1, 2}, 0.1, {6.5, 6.5}, {7, 7}), TargetVisibility::Dark);
}

TEST(Shaft, isUnknownWhereALightIsInTheWayOfRounding) {
  const LoadedLevel loaded = pillarRoom();
  EXPECT_EQ(outcomeOf(loaded.scene(), {1, 5, 2e-6}, 0, {1, 1}, {9, 3}), TargetVisibility::Unknown)
      << "rays along the floor";
}

}  // namespace
}  // namespace hearth
