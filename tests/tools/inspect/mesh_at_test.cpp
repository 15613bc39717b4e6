// The mesh that is pointed at.

#include "viewer/inspect/mesh_at.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "loaded.h"
#include "render/renderer.h"
#include "support/level_text.h"
#include "viewer/inspect/places.h"
#include "viewer/inspect/words.h"

namespace hearth {
namespace {

/// 1 m each way; the first two faces are those towards x < 0.
constexpr std::string_view kCrate =
    "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\n"
    "v -0.5 1 -0.5\nv 0.5 1 -0.5\nv 0.5 1 0.5\nv -0.5 1 0.5\n"
    "f 4 8 5 1\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 8 7 6 5\nf 1 2 3 4\n";
/// A square towards x < 0.
constexpr std::string_view kPanel = "v 0 0 0.5\nv 0 0 -0.5\nv 0 1 -0.5\nv 0 1 0.5\nf 1 4 3 2\n";

/// Two rooms of 4 by 4 m that are open to each other, and a third one that overlaps the east one.
SourcedResult roomsWithModels(const std::string& things) {
  const std::string solid = "{'texture':'#808080'}";
  return test::levelWithSourceFrom(
      "{'light':0.5,'things':[" + things + "],\n'sectors':{" +
          test::sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3,
                           "[" + solid + ",{'next':'east'}," + solid + "," + solid + "]") +
          "," +
          test::sectorText("east", "4,0, 8,0, 8,4, 4,4", 0, 3,
                           "[" + solid + "," + solid + "," + solid + ",{'next':'west'}]") +
          "," + test::sectorText("other", "5,0, 8,0, 8,4, 5,4", 0, 3) + "}}",
      "[]", {{"crate.obj", kCrate}, {"panel.obj", kPanel}});
}

const Vec3 kEye = {1, 2, 0.7};

/// What a look from the west along `direction` meets.
std::optional<MeshHit> metFrom(const LoadedLevel& level, Vec3 direction) {
  return meshAt(level.level, SectorId(0), kEye, direction);
}

TEST(MeshAt, IsTheNearestFace) {
  const SourcedResult rooms = roomsWithModels(
      "{'mesh':'crate.obj','x':6,'y':2,'sector':'east'},{'mesh':'crate.obj','x':3,'y':2}");
  const LoadedLevel& level = *rooms.result.loaded;
  const auto hit = metFrom(level, {1, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->mesh, 1U);
  EXPECT_LT(hit->face - level.level.meshes[1].firstFace, 2U);
  EXPECT_NEAR(hit->t, 1.5, 1e-12);
  EXPECT_FALSE(metFrom(level, {1, 0.4, 0})) << "beside it";
  EXPECT_FALSE(metFrom(level, {1, 0, 0.3})) << "above it";
  EXPECT_FALSE(metFrom(level, {-1, 0, 0})) << "behind the eye";
}

TEST(MeshAt, IsMetFromItsBackOnlyIfItIsTwoSided) {
  const std::string turned = "{'mesh':'panel.obj','x':3,'y':2,'angle':180";
  EXPECT_FALSE(metFrom(*roomsWithModels(turned + "}").result.loaded, {1, 0, 0}));
  EXPECT_TRUE(metFrom(*roomsWithModels(turned + ",'twoSided':true}").result.loaded, {1, 0, 0}));
}

TEST(MeshAt, OfTwoAtOneDepthIsTheLater) {
  const std::string panel = "{'mesh':'panel.obj','x':3,'y':2}";
  const auto hit = metFrom(*roomsWithModels(panel + "," + panel).result.loaded, {1, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->mesh, 1U);
}

TEST(MeshAt, IsSeenThroughAnOpeningButNotInARoomThatMerelyOverlaps) {
  const std::string crate = "{'mesh':'crate.obj','x':6.5,'y':2,'sector':";
  EXPECT_TRUE(metFrom(*roomsWithModels(crate + "'east'}").result.loaded, {1, 0, 0}));
  EXPECT_FALSE(metFrom(*roomsWithModels(crate + "'other'}").result.loaded, {1, 0, 0}));
}

TEST(MeshAt, IsFoundWhereItLiesInTheSurfaceBehind) {
  const SourcedResult rooms = roomsWithModels("{'mesh':'panel.obj','x':8,'y':2,'sector':'east'}");
  EXPECT_TRUE(metFrom(*rooms.result.loaded, {1, 0, 0}));
}

TEST(MeshAt, IsNotFoundBehindAWall) {
  const SourcedResult rooms = roomsWithModels("{'mesh':'crate.obj','x':3.8,'y':3.8}");
  EXPECT_FALSE(meshAt(rooms.result.loaded->level, SectorId(2), {7, 3.8, 0.7}, {-1, 0, 0}));
}

TEST(MeshAt, HidesASpriteByDepthAndAtOneDepthByTheirOrder) {
  const auto hidesSprite = [](const std::string& things) {
    const SourcedResult rooms = roomsWithModels(things);
    const LoadedLevel& level = *rooms.result.loaded;
    const auto sprite =
        spriteAt(level.scene(), drawnTextures(level.textures, TextureFilter::Nearest),
                 {SectorId(0), kEye, {1, 0, 0}, {0, 1}}, 100);
    return hides(level.level, metFrom(level, {1, 0, 0}).value(), sprite.value());
  };
  const std::string panel = "{'mesh':'panel.obj','x':3,'y':2}";
  const auto spriteFrom = [](std::string_view x) {
    return "{'sprite':'#c04020','y':2,'size':[1,2],'x':" + std::string(x) + "}";
  };
  EXPECT_TRUE(hidesSprite(panel + "," + spriteFrom("3.5")));
  EXPECT_FALSE(hidesSprite(spriteFrom("2.5") + "," + panel));
  EXPECT_TRUE(hidesSprite(spriteFrom("3") + "," + panel));
  EXPECT_FALSE(hidesSprite(panel + "," + spriteFrom("3")));
}

/// Two ways to the same: the picture is drawn by other means than looks are followed.
TEST(MeshAt, IsWhatThePictureShows) {
  const SourcedResult rooms = roomsWithModels(
      "{'mesh':'crate.obj','x':3.9,'y':1.2,'angle':33,'z':0.2},"
      "{'mesh':'crate.obj','x':3.5,'y':2.6,'angle':-12,'scale':[1,1,2]},"
      "{'mesh':'panel.obj','x':2.5,'y':2,'angle':150,'twoSided':true}");
  const LoadedLevel& level = *rooms.result.loaded;
  const BakedLight light = bake(level.scene(), level.level.bake, 1);
  const Camera camera{SectorId(0), kEye, 3, -10, 90, 97, 61, 0};
  const Image faces = Renderer(level.scene(), level.textures, light).draw(camera, Channel::Faces);
  const Projection projection = projectionFor(level.scene(), camera);
  std::map<std::uint32_t, Rgb> colors;  // of faces
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const Vec2 ray = projection.rayOf(x + 0.5);
      const auto hit = metFrom(level, {ray.x, ray.y, projection.raySlopeAt(y + 0.5)});
      const Rgb pixel = faces.at(x, y);
      const bool isFace = std::max({pixel.r, pixel.g, pixel.b}) >= 64;
      ASSERT_EQ(hit.has_value(), isFace) << x << ' ' << y;
      if (hit) {
        ASSERT_EQ(colors.try_emplace(hit->face, pixel).first->second, pixel) << x << ' ' << y;
      }
    }
  EXPECT_EQ(colors.size(), 8U) << "two of each side that is seen";
}

TEST(MeshAt, HasItsPlacesInTheFileAndWords) {
  const SourcedResult rooms = roomsWithModels(
      "{'sprite':'#c04020','x':1,'y':3},\n{'mesh':'panel.obj','x':3,'y':2},\n"
      "{'name':'box','mesh':'crate.obj','x':3,'y':2}");
  const auto ending = [](const std::string& place) { return place.substr(place.find(".json")); };
  EXPECT_EQ(ending(placeOfMesh(rooms.source, 0)), ".json:2 /things/1");
  EXPECT_EQ(ending(placeOfModel(rooms.source, 1)), ".json:3 /things/2/mesh");
  const Level& level = rooms.result.loaded->level;
  TruthHit hit;
  hit.mesh = level.meshes[1].surface;
  EXPECT_EQ(ending(placeOfSurface(rooms.source, level, hit)), ".json:3 /things/2");
  EXPECT_EQ(surfaceWords(level, hit), "mesh \"box\"");
  EXPECT_EQ(meshWords(level, 0), "mesh 0");
  EXPECT_EQ(meshWords(level, 1), "mesh \"box\"");
  const BakedLight light = bake(rooms.result.loaded->scene(), level.bake, 1);
  EXPECT_EQ(meshBrightnessWords(level, {1, level.meshes[1].firstFace, 0, {}}, light),
            "dim, 128 of 255: the level has no lights; the sector's own light gives 128");
}

}  // namespace
}  // namespace hearth
