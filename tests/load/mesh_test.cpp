#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "load/source.h"
#include "load_text.h"
#include "support/memory_files.h"
#include "support/temporary_folder.h"

/// What meshes become. What is wrong with some is told in bad/.
namespace hearth {
namespace {

namespace fs = std::filesystem;

const std::string kRoom = "0,0, 4,0, 4,4, 0,4";

/// A triangle, counter-clockwise as seen by one who looks along the model's -z.
const std::string kTriangle = "v 1 2 4\nv 2 2 4\nv 1 4 4\nf 1 2 3\n";

/// A TGA image of one colour.
std::string imageBytes(char width, char height, Rgb color) {
  std::string bytes(18, '\0');
  bytes[2] = 2;  // RGB, not packed
  bytes[12] = width;
  bytes[14] = height;
  bytes[16] = 24;  // bits a pixel
  for (int i = 0; i < width * height; ++i)
    for (const std::uint8_t part : {color.b, color.g, color.r}) bytes += static_cast<char>(part);
  return bytes;
}

/// A level in levels/ and its models, in memory.
class MeshLoad : public testing::Test {
 protected:
  MeshLoad() { files_.add("levels/crate.obj", kTriangle); }

  LoadResult load(std::string_view things, std::string_view sectors = sectorText("room", kRoom),
                  const LoadLimits& limits = {}) {
    std::string text =
        fmt::format("{{'light': 1, 'things': [{}], 'sectors': {{{}}}}}", things, sectors);
    std::ranges::replace(text, '\'', '"');
    files_.add("levels/level.json", text);
    return loadLevel("levels/level.json", limits, files_);
  }

  LoadedLevel loaded(std::string_view things,
                     std::string_view sectors = sectorText("room", kRoom)) {
    LoadResult result = load(things, sectors);
    if (result.loaded) return *std::move(result.loaded);
    ADD_FAILURE() << listed(result);
    std::abort();
  }

  Mesh onlyMesh(std::string_view thing, std::string_view sectors = sectorText("room", kRoom)) {
    const LoadedLevel level = loaded(thing, sectors);
    EXPECT_EQ(level.level.meshes.size(), 1U);
    return level.level.meshes.at(0);
  }

  /// The first face of a mesh of the triangle, with more keys.
  MeshFace firstFace(std::string_view more) {
    return loaded(fmt::format("{{'mesh': 'crate.obj', {}}}", more)).level.meshFaces.at(0);
  }

  /// What the faces of a level's meshes wear, by name.
  static std::vector<std::string> worn(const LoadedLevel& level) {
    std::vector<std::string> names;
    for (const MeshFace& face : level.level.meshFaces)
      names.push_back(level.level.textures[face.texture.index()]);
    return names;
  }

  test::MemoryFiles files_;
};

TEST_F(MeshLoad, takesDefaultsForAllButItsModelAndPlace) {
  const LoadedLevel level = loaded("{'mesh': 'crate.obj', 'x': 1, 'y': 2}");
  ASSERT_EQ(level.level.meshes.size(), 1U);
  const Mesh& mesh = level.level.meshes[0];
  EXPECT_EQ(mesh.name, "");
  EXPECT_EQ(mesh.position, (Vec3{1, 2, 0}));
  EXPECT_EQ(mesh.sector, SectorId(0));
  EXPECT_FALSE(mesh.isTwoSided);
  EXPECT_TRUE(mesh.isSolid);
  EXPECT_TRUE(mesh.castsShadow);
  EXPECT_EQ(mesh.firstFace, 0U);
  EXPECT_EQ(mesh.faceCount, 1U);
  EXPECT_EQ(worn(level), std::vector<std::string>{"#ffffff"});
}

TEST_F(MeshLoad, takesEveryKey) {
  const LoadedLevel level = loaded(
      "{'name': 'box', 'mesh': 'crate.obj', 'x': 1, 'y': 2, 'z': 1.5, 'sector': 'room',"
      " 'angle': 90, 'scale': [1, 2, 3], 'texture': '#c04020', 'twoSided': true,"
      " 'solid': false, 'shadow': false}");
  const Mesh& mesh = level.level.meshes.at(0);
  EXPECT_EQ(mesh.name, "box");
  EXPECT_EQ(mesh.position, (Vec3{1, 2, 1.5}));
  EXPECT_TRUE(mesh.isTwoSided);
  EXPECT_FALSE(mesh.isSolid);
  EXPECT_FALSE(mesh.castsShadow);
  EXPECT_EQ(worn(level), std::vector<std::string>{"#c04020"});
}

TEST_F(MeshLoad, hasTheModelsHeightForItsOwnAndTheModelsZForItsY) {
  const MeshFace face = firstFace("'x': 0, 'y': 0");
  EXPECT_EQ(face.corners[0], (Vec3{1, 4, 2}));
  EXPECT_EQ(face.corners[1], (Vec3{2, 4, 2}));
  EXPECT_EQ(face.corners[2], (Vec3{1, 4, 4}));
}

TEST_F(MeshLoad, hasItsFrontsWhereTheModelHasThem) {
  EXPECT_EQ(frontOf(firstFace("'x': 0, 'y': 0")), (Vec3{0, 2, 0})) << "the model's +z";
  EXPECT_EQ(frontOf(firstFace("'x': 0, 'y': 0, 'angle': 90")), (Vec3{-2, 0, 0}));
}

TEST_F(MeshLoad, isTurnedByRightAnglesExactly) {
  const auto corner = [&](int angle) {
    return firstFace(fmt::format("'x': 0, 'y': 0, 'angle': {}", angle)).corners[1];
  };
  EXPECT_EQ(corner(90), (Vec3{-4, 2, 2})) << "+x turns to +y";
  EXPECT_EQ(corner(180), (Vec3{-2, -4, 2}));
  EXPECT_EQ(corner(-90), (Vec3{4, -2, 2}));
}

TEST_F(MeshLoad, isTurnedByOtherAngles) {
  const Vec3 corner = firstFace("'x': 0, 'y': 0, 'angle': 30").corners[1];
  EXPECT_NEAR(corner.x, 2 * std::sqrt(0.75) - 4 * 0.5, 1e-15);
  EXPECT_NEAR(corner.y, 2 * 0.5 + 4 * std::sqrt(0.75), 1e-15);
  EXPECT_EQ(corner.z, 2);
}

TEST_F(MeshLoad, isScaledAlongTheLevelsAxesThenTurnedThenMoved) {
  EXPECT_EQ(firstFace("'x': 0, 'y': 0, 'scale': 0.5").corners[1], (Vec3{1, 2, 1}));
  EXPECT_EQ(firstFace("'x': 0, 'y': 0, 'scale': [3, 5, 7]").corners[1], (Vec3{6, 20, 14}));
  EXPECT_EQ(firstFace("'x': 1, 'y': 2, 'z': 0.5, 'scale': [3, 5, 7], 'angle': 90").corners[1],
            (Vec3{1 - 20, 2 + 6, 0.5 + 14}));
}

TEST_F(MeshLoad, hasTheBottomOfItsImageAtZero) {
  files_.add("levels/crate.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 2 0.25\nvt -1 3\nf 1/1 2/2 3/3\n");
  const MeshFace face = firstFace("'x': 1, 'y': 1");
  EXPECT_EQ(face.image[0], (Vec2{0, 1}));
  EXPECT_EQ(face.image[1], (Vec2{2, 0.75}));
  EXPECT_EQ(face.image[2], (Vec2{-1, -2}));
}

TEST_F(MeshLoad, keepsItsPlaceAmongTheThingsOfTheFile) {
  const Level level = loaded(
                          "{'mesh': 'crate.obj', 'x': 1, 'y': 1},"
                          "{'sprite': '#c04020', 'x': 1, 'y': 1},"
                          "{'sprite': '#c04020', 'x': 1, 'y': 1},"
                          "{'mesh': 'crate.obj', 'x': 1, 'y': 1}")
                          .level;
  ASSERT_EQ(level.meshes.size(), 2U);
  ASSERT_EQ(level.sprites.size(), 2U);
  EXPECT_EQ(level.meshes[0].thing, 0U);
  EXPECT_EQ(level.sprites[0].thing, 1U);
  EXPECT_EQ(level.sprites[1].thing, 2U);
  EXPECT_EQ(level.meshes[1].thing, 3U);
}

TEST_F(MeshLoad, hasFacesOfItsOwn) {
  files_.add("levels/square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const Level level = loaded(
                          "{'mesh': 'square.obj', 'x': 1, 'y': 1},"
                          "{'mesh': 'crate.obj', 'x': 0, 'y': 0},"
                          "{'mesh': 'square.obj', 'x': 2, 'y': 1}")
                          .level;
  ASSERT_EQ(level.meshFaces.size(), 5U);
  EXPECT_EQ(level.facesOf(level.meshes[0]).size(), 2U);
  EXPECT_EQ(level.facesOf(level.meshes[1])[0].corners[0], (Vec3{1, 4, 2}));
  EXPECT_EQ(level.facesOf(level.meshes[2])[1].corners[2], (Vec3{2, 1, 1}));
}

TEST_F(MeshLoad, standsOnASlope) {
  EXPECT_EQ(onlyMesh("{'mesh': 'crate.obj', 'x': 3, 'y': 1}",
                     sectorText("room", kRoom, "{'texture': '#808080'}",
                                "'slopeFloor': {'z': [0, 2, 2, 0]}"))
                .position.z,
            1.5);
}

TEST_F(MeshLoad, isInTheSectorThatItNamesWhereSeveralLie) {
  const std::string both = sectorText("one", kRoom) + "," + sectorText("two", kRoom);
  EXPECT_EQ(onlyMesh("{'mesh': 'crate.obj', 'x': 1, 'y': 1, 'sector': 'two'}", both).sector,
            SectorId(1));
  EXPECT_EQ(countErrors(load("{'mesh': 'crate.obj', 'x': 1, 'y': 1}", both)), 1U);
}

TEST_F(MeshLoad, mayReachOutOfTheLevel) {
  EXPECT_EQ(onlyMesh("{'mesh': 'crate.obj', 'x': 1, 'y': 1, 'scale': 1000}").faceCount, 1U);
}

TEST_F(MeshLoad, leavesOutFacesThatScalingTakesTheAreaOf) {
  files_.add("levels/crate.obj", kTriangle +
                                     "v 1 1 1\nv 1.00000000001 1 1\nv 1 1.00000000001 1\n"
                                     "f 4 5 6\n");
  EXPECT_EQ(onlyMesh("{'mesh': 'crate.obj', 'x': 1, 'y': 1}").faceCount, 2U);
  EXPECT_EQ(onlyMesh("{'mesh': 'crate.obj', 'x': 1, 'y': 1, 'scale': 1e-6}").faceCount, 1U);
}

/// A model in a folder of its own, with a material of an image, one of a colour and a face without.
class MeshMaterials : public MeshLoad {
 protected:
  MeshMaterials() {
    files_.add("levels/models/crate.obj",
               "mtllib crate.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\n"
               "f 1 2 3\nusemtl oak\nf 1 2 3\nusemtl paint\nf 1 2 3\n");
    files_.add("levels/models/crate.mtl",
               "newmtl paint\nKd 1 0.5 0\n"
               "newmtl oak\nKd 1 1 1\nmap_Kd wood/oak.tga\n"
               "newmtl unused\nmap_Kd none.png\n");
    files_.add("levels/models/wood/oak.tga", imageBytes(3, 2, {10, 20, 30}));
    files_.add("textures/plaster.tga", imageBytes(4, 5, {40, 50, 60}));
  }

  static constexpr std::string_view kCrate = "{'mesh': 'models/crate.obj', 'x': 1, 'y': 1}";
};

TEST_F(MeshMaterials, wearsImagesColoursAndWhite) {
  const LoadedLevel level = loaded(kCrate);
  EXPECT_EQ(worn(level), (std::vector<std::string>{"#ffffff", "models/wood/oak.tga", "#ff8000"}));
  const auto imageOf = [&](std::size_t face) {
    return level.textures[level.level.meshFaces[face].texture.index()];
  };
  EXPECT_EQ(imageOf(0), Image(1, 1, {255, 255, 255}));
  EXPECT_EQ(imageOf(1), Image(3, 2, {10, 20, 30}));
  EXPECT_EQ(imageOf(2), Image(1, 1, {255, 128, 0}));
  EXPECT_EQ(level.decodedImages, 1U);
}

TEST_F(MeshMaterials, wearsItsTextureWhereAFaceHasNone) {
  const LoadedLevel level =
      loaded("{'mesh': 'models/crate.obj', 'x': 1, 'y': 1, 'texture': 'plaster'}");
  EXPECT_EQ(worn(level).at(0), "plaster");
  EXPECT_EQ(level.textures[level.level.meshFaces[0].texture.index()], Image(4, 5, {40, 50, 60}));
  EXPECT_EQ(worn(level).at(1), "models/wood/oak.tga");
  EXPECT_EQ(level.decodedImages, 2U);
}

TEST_F(MeshMaterials, needsItsTextureThoughNoFaceWearsIt) {
  files_.add("levels/models/crate.obj",
             "mtllib crate.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl paint\nf 1 2 3\n");
  const std::string crate = "{{'mesh': 'models/crate.obj', 'x': 1, 'y': 1, 'texture': '{}'}}";
  EXPECT_EQ(loaded(fmt::format(fmt::runtime(crate), "plaster")).decodedImages, 0U);
  EXPECT_EQ(countErrors(load(fmt::format(fmt::runtime(crate), "none"))), 1U);
}

TEST_F(MeshMaterials, sharesAnImageThatSeveralMaterialsName) {
  files_.add("levels/models/table.obj",
             "mtllib table.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl top\nf 1 2 3\n");
  files_.add("levels/models/table.mtl", "newmtl top\nmap_Kd wood/oak.tga\n");
  const LoadedLevel level =
      loaded(std::string(kCrate) + ", {'mesh': 'models/table.obj', 'x': 1, 'y': 1}");
  EXPECT_EQ(level.level.meshFaces.at(3).texture, level.level.meshFaces.at(1).texture);
  EXPECT_EQ(level.decodedImages, 1U);
}

TEST_F(MeshMaterials, listsAllThatWasRead) {
  const LoadedLevel level = loaded(std::string(kCrate) + "," + std::string(kCrate) +
                                   ", {'mesh': 'crate.obj', 'x': 1, 'y': 1, 'texture': 'plaster'}");
  std::vector<std::string> files;
  for (const fs::path& file : level.files) files.push_back(file.lexically_normal().string());
  EXPECT_EQ(files, (std::vector<std::string>{
                       "levels/level.json", "levels/models/crate.obj", "levels/models/crate.mtl",
                       "levels/crate.obj", "levels/models/wood/oak.tga", "textures/plaster.tga"}));
}

TEST_F(MeshMaterials, tellsOfAMissingImageWhichFileNamesIt) {
  files_.remove("levels/models/wood/oak.tga");
  const LoadResult result = load(kCrate);
  ASSERT_EQ(countErrors(result), 1U) << listed(result);
  EXPECT_EQ(result.diagnostics[0].message,
            "there is no file levels/models/wood/oak.tga, which levels/models/crate.mtl:5 names");
  EXPECT_EQ(result.diagnostics[0].pointer, "/things/0/mesh");
}

TEST_F(MeshMaterials, tellsOnceWhatItLeavesOut) {
  files_.add("levels/models/crate.mtl", "newmtl paint\nKs 1 1 1\nnewmtl oak\n");
  files_.add("levels/models/other.obj",
             "mtllib crate.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl paint\nf 1 2 3\n");
  const LoadResult result = load(std::string(kCrate) + "," + std::string(kCrate) +
                                 ", {'mesh': 'models/other.obj', 'x': 1, 'y': 1}");
  ASSERT_EQ(result.diagnostics.size(), 1U) << listed(result);
  EXPECT_EQ(result.diagnostics[0].kind, "model-skips");
  EXPECT_EQ(result.diagnostics[0].pointer, "/things/0/mesh");
  EXPECT_TRUE(result.diagnostics[0].message.starts_with("levels/models/crate.mtl:2: "));
  EXPECT_TRUE(result.loaded);
}

TEST_F(MeshLoad, hasASurfaceAfterAllOthers) {
  const LoadedLevel loadedLevel = loaded(
      "{'mesh': 'crate.obj', 'x': 1, 'y': 1},"
      "{'sprite': '#c04020', 'x': 1, 'y': 1},"
      "{'mesh': 'crate.obj', 'x': 1, 'y': 1}");
  const Level& level = loadedLevel.level;
  ASSERT_EQ(level.surfaces.size(), 6U + 3U) << "of the room: four walls and two flats";
  EXPECT_EQ(level.surfaces[6].kind, SurfaceKind::CameraSprite);
  EXPECT_EQ(level.surfaces[7].kind, SurfaceKind::Mesh);
  EXPECT_EQ(level.surfaces[8].kind, SurfaceKind::Mesh);
  EXPECT_EQ(&level.meshOf(SurfaceId(8)), &level.meshes[1]);
}

TEST_F(MeshLoad, isInTheAirOfItsSector) {
  const Level level = loaded("{'mesh': 'crate.obj', 'x': 1, 'y': 1}").level;
  ASSERT_EQ(level.meshesIn(SectorId(0)).size(), 1U);
  EXPECT_EQ(level.meshesIn(SectorId(0))[0].mesh, 0U);
}

TEST_F(MeshLoad, ofALevelWithoutThingsIsNone) {
  const Level level = loaded("").level;
  EXPECT_TRUE(level.meshes.empty());
  EXPECT_TRUE(level.meshFaces.empty());
}

TEST_F(MeshLoad, ofMoreFacesThanTheLimitIsRefusedOnce) {
  files_.add("levels/square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const std::string square = "{'mesh': 'square.obj', 'x': 1, 'y': 1}";
  LoadLimits limits;
  limits.meshFaces = 4;
  const std::string room = sectorText("room", kRoom);
  EXPECT_TRUE(load(square + "," + square, room, limits).loaded);
  const LoadResult result = load(square + "," + square + "," + square + "," + square, room, limits);
  ASSERT_EQ(result.diagnostics.size(), 1U) << listed(result);
  EXPECT_EQ(result.diagnostics[0].pointer, "/things/2/mesh");
  EXPECT_EQ(result.diagnostics[0].advice, "raise the limit with --max-mesh-faces");
}

TEST_F(MeshLoad, ofWhichThereAreMoreThanFacesMayBeIsNotLookedAt) {
  LoadLimits limits;
  limits.meshFaces = 2;
  const LoadResult result =
      load("{'mesh': 1}, {'mesh': 2}, {'mesh': 3}", sectorText("room", kRoom), limits);
  ASSERT_EQ(result.diagnostics.size(), 1U) << listed(result);
  EXPECT_EQ(result.diagnostics[0].pointer, "/things");
  EXPECT_EQ(result.diagnostics[0].advice, "raise the limit with --max-mesh-faces");
}

TEST_F(MeshLoad, ofAModelThatIsBrokenIsToldAtItsFirstUse) {
  files_.add("levels/crate.obj", "v 1 2\nf 1 2 3\n");
  const LoadResult result = load(
      "{'sprite': '#c04020', 'x': 1, 'y': 1},"
      "{'mesh': 'crate.obj', 'x': 1, 'y': 1},"
      "{'mesh': 'crate.obj', 'x': 2, 'y': 1}");
  ASSERT_GT(countErrors(result), 0U);
  for (const Diagnostic& diagnostic : result.diagnostics) {
    EXPECT_EQ(diagnostic.pointer, "/things/1/mesh") << format(diagnostic);
    EXPECT_TRUE(diagnostic.message.starts_with("levels/crate.obj:")) << format(diagnostic);
  }
}

TEST(MeshReload, keepsTheMeshesWhereOnlyLightsChange) {
  const test::TemporaryFolder folder;
  folder.write("crate.obj", kTriangle);
  folder.write("level.lights.json", R"([ {"x": 1, "y": 2, "z": 1} ])");
  std::string text = "{'things': [{'mesh': 'crate.obj', 'x': 1, 'y': 1}], 'sectors': {" +
                     sectorText("room", kRoom) + "}}";
  std::ranges::replace(text, '\'', '"');
  SourcedResult opened = loadLevelWithSource(folder.write("level.json", text));
  ASSERT_TRUE(opened.result.loaded) << listed(opened.result);
  folder.write("level.lights.json", R"([ {"x": 2, "y": 2, "z": 1} ])");
  const auto reloaded = reloadLights(*opened.result.loaded, opened.source);
  ASSERT_TRUE(reloaded && reloaded->loaded);
  const Level& level = reloaded->loaded->level;
  EXPECT_EQ(level.lights.at(0).position.x, 2);
  EXPECT_EQ(level.meshes.size(), 1U);
  EXPECT_EQ(level.meshFaces.size(), 1U);
  EXPECT_EQ(level.meshesBySector.size(), 1U);
  EXPECT_EQ(reloaded->loaded->files, opened.result.loaded->files);
}

}  // namespace
}  // namespace hearth
