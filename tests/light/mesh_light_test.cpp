// Light on the faces of meshes: on texel grids where faces are larger than a texel, at their
// corners where they are smaller.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "light/geometry_hash.h"
#include "light/lit_mesh.h"
#include "light/saved_bake.h"
#include "support/baked_room.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::kBoxModel;
using test::kPanelModel;
using test::levelFrom;
using test::NamedText;
using test::sectorText;

constexpr Vec3 kWest{-1, 0, 0};
constexpr Vec3 kUp{0, 0, 1};
constexpr Vec3 kLampAt{2, 4, 3};
constexpr std::string_view kLamp = "{'x':2,'y':4,'z':3,'intensity':200,'falloff':0.5}";

double lampAt(Vec3 p) { return 200 / (1 + 0.5 * length(kLampAt - p)); }

/// A box of 1 m, of which 10 cm are below its origin.
constexpr std::string_view kSunkBox =
    "v -0.5 -0.1 -0.5\nv 0.5 -0.1 -0.5\nv 0.5 -0.1 0.5\nv -0.5 -0.1 0.5\n"
    "v -0.5 0.9 -0.5\nv 0.5 0.9 -0.5\nv 0.5 0.9 0.5\nv -0.5 0.9 0.5\n"
    "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n";

/// The panel of 1 m, of ten upright pieces, or of a hundred.
std::string cutPanel(int across, int up) {
  std::string text;
  for (int i = 0; i <= across; ++i)
    for (int j = 0; j <= up; ++j)
      text += fmt::format("v 0 {} {}\n", 1.0 * j / up, 1.0 * i / across - 0.5);
  const auto corner = [&](int i, int j) { return i * (up + 1) + j + 1; };
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < up; ++j)
      text += fmt::format("f {} {} {} {}\n", corner(i, j), corner(i, j + 1), corner(i + 1, j + 1),
                          corner(i + 1, j));
  return text;
}

/// A ball with a radius of 1 m around a point 1 m above its origin.
std::string ball(int around) {
  const int down = around / 2;
  std::string text;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j <= down; ++j) {
      const double turn = 2 * std::numbers::pi * i / around;
      const double fall = std::numbers::pi * j / down;
      text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", std::sin(fall) * std::cos(turn),
                          1 + std::cos(fall), std::sin(fall) * std::sin(turn));
    }
  const auto corner = [&](int i, int j) { return (i % around) * (down + 1) + j + 1; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < down; ++j)
      text += fmt::format("f {} {} {} {}\n", corner(i + 1, j), corner(i + 1, j + 1),
                          corner(i, j + 1), corner(i, j));
  return text;
}

LoadedLevel hallWith(std::string_view things, std::string_view lights,
                     std::string_view bake = "'texel':0.1") {
  const std::string strips = cutPanel(10, 1);
  const std::string squares = cutPanel(10, 10);
  const std::string round = ball(100);
  return levelFrom(fmt::format("{{'things':[{}],'sectors':{{{}}}}}", things,
                               sectorText("hall", "0,0, 12,0, 12,8, 0,8", 0, 6)),
                   fmt::format("{{'lights':[{}],'bake':{{{}}}}}", lights, bake),
                   {{"box.obj", kBoxModel},
                    {"panel.obj", kPanelModel},
                    {"sunk.obj", kSunkBox},
                    {"strips.obj", strips},
                    {"squares.obj", squares},
                    {"ball.obj", round}});
}

TEST(MeshLight, ofALampFallsOffWithTheDistanceOnEachFaceThatItSees) {
  const BakedRoom room(hallWith("{'mesh':'box.obj','x':4,'y':4}", kLamp));
  for (const double along : {3.6, 4.0, 4.4})
    for (const double up : {0.1, 0.5, 0.9}) {
      const Vec3 onSide{3.5, along, up};
      EXPECT_NEAR(room.onMesh(onSide, kWest), lampAt(onSide), 1);
      const Vec3 onTop{along, 3.5 + up, 1};
      EXPECT_NEAR(room.onMesh(onTop, kUp), lampAt(onTop), 1);
      EXPECT_EQ(room.onMesh({4.5, along, up}, {1, 0, 0}), 0) << "it faces away";
    }
}

TEST(MeshLight, isLessAsACosineWithLambert) {
  const BakedRoom room(
      hallWith("{'mesh':'box.obj','x':4,'y':4}", kLamp, "'texel':0.1,'lambert':true"));
  const Vec3 p{3.5, 4, 0.5};
  EXPECT_NEAR(room.onMesh(p, kWest), lampAt(p) * 1.5 / length(kLampAt - p), 1);
}

/// At the corners of faces of 6 cm and in the middle of others.
TEST(MeshLight, isFoundAtTheCornersOfFacesSmallerThanATexel) {
  const BakedRoom room(hallWith("{'mesh':'ball.obj','x':6,'y':4}", kLamp));
  int lit = 0;
  for (const MeshFace& face : room.level().meshFaces) {
    const Vec3 front = frontOf(face);
    const Vec3 middle = (1.0 / 3) * (face.corners[0] + face.corners[1] + face.corners[2]);
    const double inFront = dot(kLampAt - middle, front) / length(front);
    if (std::abs(inFront) < 0.2) continue;  // rays graze the ball
    for (const Vec3 p : {middle, face.corners[1]}) {
      const double expected = inFront > 0 ? lampAt(p) : 0;
      EXPECT_NEAR(room.onMesh(0.9 * p + 0.1 * middle, front), expected, 1.5);
    }
    lit += inFront > 0 ? 1 : 0;
  }
  EXPECT_GT(lit, 2000);
}

/// Rounding makes some of their sides longer than a texel, and some shorter.
TEST(MeshLight, isFoundAtTheCornersOfFacesAsLargeAsATexel) {
  constexpr double kTexel = 0.25;
  for (int i = 0; i < 40; ++i) {
    const LoadedLevel hall = hallWith(
        fmt::format("{{'mesh':'box.obj','x':{0},'y':4,'z':{0},'scale':{1}}}", 1 + 0.1 * i, kTexel),
        kLamp);
    EXPECT_TRUE(makeLitMesh(hall.level, 0, kTexel).patches.empty()) << i;
  }
}

/// The edge of the shadow of a wall of 1 m runs across the panel.
TEST(MeshLight, isThatOfOneSurfaceWhereFacesInOnePlaneAreCut) {
  const std::string wall = "{'mesh':'panel.obj','x':4,'y':4.1,'scale':[1,1,2.5],'angle':7},";
  const auto room = [&](std::string_view model) {
    return BakedRoom(hallWith(
        wall + "{'mesh':'" + std::string(model) + "','x':6,'y':4,'angle':180,'scale':[1,3,3]}",
        kLamp, "'texel':0.2"));
  };
  const BakedRoom whole = room("panel.obj");
  const BakedRoom strips = room("strips.obj");
  const BakedRoom squares = room("squares.obj");
  constexpr double kRounding = 1e-9;
  bool hasLight = false;
  bool hasShadow = false;
  for (double y = 2.55; y < 5.5; y += 0.07)
    for (double z = 0.03; z < 3; z += 0.07) {
      const Vec3 p{6, y, z};
      const double expected = whole.onMesh(p, kWest);
      EXPECT_NEAR(strips.onMesh(p, kWest), expected, kRounding);
      EXPECT_NEAR(squares.onMesh(p, kWest), expected, kRounding);
      hasLight = hasLight || expected > 50;
      hasShadow = hasShadow || expected == 0;
    }
  EXPECT_TRUE(hasLight && hasShadow);
}

TEST(MeshLight, ofAMeshAcrossAnOpeningComesFromBothSectors) {
  const LoadedLevel loaded =
      levelFrom("{'things':[{'mesh':'box.obj','x':6,'y':4,'sector':'west'}],'sectors':{" +
                    sectorText("west", "0,0, 6,0, 6,8, 0,8", 0, 6,
                               "[{'texture':'#808080'},{'next':'east'},{'texture':'#808080'},"
                               "{'texture':'#808080'}]") +
                    "," +
                    sectorText("east", "6,0, 12,0, 12,8, 6,8", 0, 6,
                               "[{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'},"
                               "{'next':'west'}]") +
                    "," + sectorText("apart", "0,0, 12,0, 12,8, 0,8", 0, 6) + "}}",
                "[{'x':10,'y':4,'z':0.5,'sector':'east'},{'x':2,'y':4,'z':0.5,'sector':'apart'}]",
                {{"box.obj", kBoxModel}});
  const BakedRoom room{LoadedLevel(loaded)};
  EXPECT_EQ(room.onMesh({6.5, 4, 0.5}, {1, 0, 0}), 255);
  EXPECT_EQ(room.onMesh({5.5, 4, 0.5}, kWest), 0) << "the other lamp's sector merely overlaps";
}

/// The dark samples beyond floor and ceiling are left out.
TEST(MeshLight, goesOnUpToFloorsAndCeilingsThatAMeshReachesThrough) {
  const BakedRoom room(hallWith("{'mesh':'sunk.obj','x':4,'y':4,'scale':[1,1,9]}",
                                "{'x':2,'y':4,'z':3}", "'texel':0.3"));
  for (double z = 0.01; z < 6; z += 0.01) EXPECT_EQ(room.onMesh({3.5, 4, z}, kWest), 255) << z;
}

TEST(MeshLight, hasTheColoursOfLamps) {
  const BakedRoom room(
      hallWith("{'mesh':'box.obj','x':4,'y':4}", "{'x':2,'y':4,'z':0.5,'color':'#ff8000'}"));
  EXPECT_EQ(room.onMesh({3.5, 4, 0.5}, kWest, 0), 255);
  EXPECT_EQ(room.onMesh({3.5, 4, 0.5}, kWest, 1), 128);
  EXPECT_EQ(room.onMesh({3.5, 4, 0.5}, kWest, 2), 0);
}

TEST(MeshLight, isTheSameOnAnyNumberOfThreads) {
  const auto light = [](int threads) {
    const LoadedLevel loaded =
        hallWith("{'mesh':'ball.obj','x':6,'y':4},{'mesh':'box.obj','x':4,'y':4,'angle':20}",
                 "{'x':2,'y':4,'z':3,'radius':0.3,'color':'#ffc080'}");
    return encodeBake(loaded.scene(), bake(loaded.scene(), loaded.level.bake, threads),
                      loaded.level.bake.texel, "");
  };
  const std::string one = light(1);
  EXPECT_EQ(light(2), one);
  EXPECT_EQ(light(5), one);
}

TEST(MeshLight, isSavedAndReadAgain) {
  const LoadedLevel loaded = hallWith("{'mesh':'box.obj','x':4,'y':4,'angle':20}", kLamp);
  const Scene scene = loaded.scene();
  const BakedLight light = bake(scene, loaded.level.bake, 2);
  const std::string bytes = encodeBake(scene, light, loaded.level.bake.texel, "");
  const auto read = decodeBake(scene, bytes, 1 << 24);
  ASSERT_TRUE(read) << read.error().what;
  const std::size_t mesh = loaded.level.meshes.front().surface.index();
  ASSERT_TRUE(read->lightmaps[mesh]);
  EXPECT_EQ(read->lightmaps[mesh]->levels, light.lightmaps[mesh]->levels);
  EXPECT_EQ(read->meshes.front().places, light.meshes.front().places);
  EXPECT_EQ(read->stats.texels, light.stats.texels);
  const LoadedLevel moved = hallWith("{'mesh':'box.obj','x':4.01,'y':4,'angle':20}", kLamp);
  EXPECT_FALSE(decodeBake(moved.scene(), bytes, 1 << 24));
}

}  // namespace
}  // namespace hearth
