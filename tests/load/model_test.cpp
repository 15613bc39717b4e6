#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "math/vec.h"
#include "memory_model.h"

/// What OBJ and MTL files become. What is wrong with some is in model_mistakes_test.cpp.
namespace hearth {
namespace {

namespace fs = std::filesystem;

using Corners = std::array<Vec3, 3>;

std::vector<Corners> cornersOf(const Model& model) {
  std::vector<Corners> corners;
  for (const ModelFace& face : model.faces) corners.push_back(face.corners);
  return corners;
}

TEST(Model, isItsTrianglesWithTheirLines) {
  const Model model = modelOf("v 1 2 3\nv 4.5 -6e-1 7\n\nv 8 9 10\nf 1 2 3\nf 3 2 1\n");
  ASSERT_EQ(model.faces.size(), 2U);
  EXPECT_EQ(model.faces[0].corners, (Corners{Vec3{1, 2, 3}, {4.5, -0.6, 7}, {8, 9, 10}}));
  EXPECT_EQ(model.faces[0].line, 5U);
  EXPECT_EQ(model.faces[0].material, std::nullopt);
  EXPECT_EQ(model.faces[0].image, (std::array<Vec2, 3>{}));
  EXPECT_EQ(model.faces[1].corners, (Corners{Vec3{8, 9, 10}, {4.5, -0.6, 7}, {1, 2, 3}}));
  EXPECT_EQ(model.faces[1].line, 6U);
  EXPECT_TRUE(model.materials.empty());
}

TEST(Model, countsTheVerticesAndPolygonsOfItsFile) {
  const Model model = modelOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nf 1 2 3 4\nf 4 3 2\n");
  EXPECT_EQ(model.vertices, 5U);
  EXPECT_EQ(model.polygons, 2U);
  EXPECT_EQ(model.faces.size(), 3U);
}

TEST(Model, keepsTheOrderOfCornersWhichTellsTheFront) {
  // The back of a cube about the origin, seen from behind it.
  const Model model = modelOf("v 1 -1 -1\nv -1 -1 -1\nv -1 1 -1\nv 1 1 -1\nf 1 2 3 4\n");
  ASSERT_EQ(model.faces.size(), 2U);
  for (const ModelFace& face : model.faces) {
    const auto& [a, b, c] = face.corners;
    EXPECT_EQ(cross(b - a, c - a), (Vec3{0, 0, -4})) << "out of the cube";
  }
}

TEST(Model, hasTheNearestDoubles) {
  const Model model = modelOf("v 0.1 1e-320 9007199254740993e-7\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(model.faces[0].corners[0], (Vec3{0.1, 1e-320, 9007199254740993e-7}));
}

TEST(Model, hasPolygonsAsFansFromTheirFirstCorner) {
  const Model model = modelOf(
      "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 2 0\nvt 3 0\nvt 4 0\n"
      "f 1/5 2/4 3/3 4/2 5/1\n");
  const Vec3 a{0, 0, 0};
  const Vec3 b{2, 0, 0};
  const Vec3 c{3, 1, 0};
  const Vec3 d{2, 2, 0};
  const Vec3 e{0, 2, 0};
  EXPECT_EQ(cornersOf(model), (std::vector<Corners>{{a, b, c}, {a, c, d}, {a, d, e}}));
  EXPECT_EQ(model.faces[2].image, (std::array<Vec2, 3>{Vec2{4, 0}, {1, 0}, {0, 0}}));
}

TEST(Model, takesEveryFormOfACorner) {
  const std::string vertices = kSquareVertices + "vt 0.25\nvt 0.5 0.75\nvt 1 2\n";
  const Model model = modelOf(vertices + "f 1 2/1 3/2/1\nf 1//7 2//8 3/3/9\nf 1/1/ 2// 3/2\n");
  const Vec2 none;
  EXPECT_EQ(model.faces[0].image, (std::array<Vec2, 3>{none, {0.25, 0}, {0.5, 0.75}}));
  EXPECT_EQ(model.faces[1].image, (std::array<Vec2, 3>{none, none, {1, 2}}));
  EXPECT_EQ(model.faces[2].image, (std::array<Vec2, 3>{Vec2{0.25, 0}, none, {0.5, 0.75}}));
}

TEST(Model, countsNegativeNumbersBackFromTheirLine) {
  const Model model = modelOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 7 7\nf -3/-1 -2 -1\n" +
                              std::string("v 5 5 5\nvt 8 8\nf -4/-2 -3/-1 -1\n"));
  const Vec3 o{0, 0, 0};
  EXPECT_EQ(cornersOf(model), (std::vector<Corners>{{o, {1, 0, 0}, {0, 1, 0}},  //
                                                    {o, {1, 0, 0}, {5, 5, 5}}}));
  EXPECT_EQ(model.faces[0].image[0], (Vec2{7, 7}));
  EXPECT_EQ(model.faces[1].image[0], (Vec2{7, 7}));
  EXPECT_EQ(model.faces[1].image[1], (Vec2{8, 8}));
}

TEST(Model, mayHaveItsVerticesAfterItsFaces) {
  EXPECT_EQ(modelOf("f 1 2 3\n" + kSquareVertices).faces.size(), 1U);
}

TEST(Model, leavesOutWeightsAndColoursOfVertices) {
  const ModelRead read = readObj("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0 what ever\nf 1 2 3\n");
  ASSERT_TRUE(read.model);
  EXPECT_EQ(read.model->faces[0].corners[1], (Vec3{1, 0, 0}));
}

TEST(Model, isTheSameWithAnyBlanksAndEndsOfLines) {
  const std::vector<Corners> plain = cornersOf(modelOf(kSquareVertices + "f 1 2 3 4"));
  std::string text = kSquareVertices + "\n \t\n# f 1 2\nf 1 2 3 4\n";
  EXPECT_EQ(cornersOf(modelOf(text)), plain);
  std::string tabs = text;
  std::ranges::replace(tabs, ' ', '\t');
  EXPECT_EQ(cornersOf(modelOf(tabs)), plain);
  std::string crlf;
  for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(cornersOf(modelOf(crlf)), plain);
  EXPECT_EQ(cornersOf(modelOf("\xEF\xBB\xBF" + text)), plain);
  EXPECT_EQ(cornersOf(modelOf("  v 0 0 0 \nv 1 0 0 # one\nv 1 1 0 # two\nv 0 1 0\nf 1 2 3 4 # 5")),
            plain);
}

TEST(Model, joinsLinesThatEndWithABackslash) {
  for (const std::string end : {"\n", "\r\n"}) {
    const std::string joined = "\\" + end;
    const Model model =
        modelOf("v 0 " + joined + " 0 0" + end + "v 1 0" + joined + "0" + end + "v 1 1 0" + end +
                "v 0 1 0" + end + "f 1 2 " + joined + joined + "3 4" + end + "f 4 3 2 " + joined);
    ASSERT_EQ(model.faces.size(), 3U);
    EXPECT_EQ(model.faces[0].line, 7U);
    EXPECT_EQ(model.faces[2].line, 10U);
  }
}

TEST(Model, doesNotJoinALineToAComment) {
  EXPECT_EQ(modelOf("# a drawing: /\\\n" + kSquareVertices + "f 1 2 3\n").faces.size(), 1U);
}

TEST(Model, wearsItsMaterialsFromEachUsemtlOn) {
  const Model model =
      modelOf("mtllib crate.mtl\n" + kSquareVertices +
                  "f 1 2 3\nusemtl dark red\nf 1 2 3\nf 1 3 4\nusemtl plain\nf 1 2 3\n"
                  "usemtl \t dark red \nf 1 2 3\n",
              "newmtl unused\nKd 0 0 1\nmap_Kd unused.png\n"
              "newmtl plain\n\nnewmtl dark red\nKd 0.5 0.25 0.001\n");
  std::vector<std::optional<std::uint32_t>> worn;
  for (const ModelFace& face : model.faces) worn.push_back(face.material);
  EXPECT_EQ(worn, (std::vector<std::optional<std::uint32_t>>{std::nullopt, 0, 0, 1, 0}));
  ASSERT_EQ(model.materials.size(), 2U) << "only those that it uses";
  EXPECT_EQ(model.materials[0].color, (Rgb{128, 64, 0})) << "rounded half up";
  EXPECT_EQ(model.materials[0].image, std::nullopt);
  EXPECT_EQ(model.materials[1].color, (Rgb{255, 255, 255}));
}

TEST(Model, takesAColorOfOneNumberForGrey) {
  const Model model =
      modelOf("mtllib crate.mtl\nusemtl a\n" + kSquareVertices + "f 1 2 3\n", "newmtl a\nKd 0.2\n");
  EXPECT_EQ(model.materials[0].color, (Rgb{51, 51, 51}));
}

TEST(Model, mayUseMaterialsBeforeItNamesTheirFile) {
  const std::string faces = kSquareVertices + "usemtl a\nf 1 2 3\n";
  EXPECT_EQ(modelOf(faces + "mtllib crate.mtl\n", "newmtl a\n").materials.size(), 1U);
}

/// The image of the one material of models/crate.obj, whose file of materials has a name.
fs::path imageOf(const std::string& library, const std::string& statement) {
  test::MemoryFiles files;
  files.add("models/crate.obj",
            "mtllib " + library + "\nusemtl a\n" + kSquareVertices + "f 1 2 3\n");
  files.add(fs::path("models") / library, "newmtl a\n" + statement + "\n");
  const ModelRead read = readModel("models/crate.obj", {}, files);
  EXPECT_TRUE(read.model) << listed(read);
  return read.model ? read.model->materials.at(0).image.value_or("none") : "";
}

TEST(Model, findsImagesFromTheFolderOfTheirMaterials) {
  EXPECT_EQ(imageOf("crate.mtl", "map_Kd wood.png"), "models/wood.png");
  EXPECT_EQ(imageOf("crate.mtl", "map_Kd old wood.png "), "models/old wood.png");
  EXPECT_EQ(imageOf("crate.mtl", "map_Kd ../images/wood.png"), "models/../images/wood.png");
  EXPECT_EQ(imageOf("crate.mtl", "map_Kd /images/wood.png"), "/images/wood.png");
  EXPECT_EQ(imageOf("parts/crate.mtl", "map_Kd wood.png"), "models/parts/wood.png");
  EXPECT_EQ(imageOf("crate.mtl", "map_Kd images\\\\old\\wood.png"), "models/images/old/wood.png");
  EXPECT_EQ(imageOf("crate.mtl", "Kd 1 0 0"), "none");
}

TEST(Model, findsTheImageBehindOptions) {
  EXPECT_EQ(imageOf("crate.mtl", "map_Kd -s 2 2 1 -clamp on\twood.png"), "models/wood.png");
}

TEST(Model, tellsTheFilesThatWereRead) {
  test::MemoryFiles files;
  files.add("crate.obj", "mtllib a.mtl b.mtl\nmtllib a.mtl\n" + kSquareVertices +
                             "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
  files.add("a.mtl", "newmtl a\n");
  files.add("b.mtl", "newmtl b\n");
  const ModelRead read = readModel("crate.obj", {}, files);
  EXPECT_TRUE(read.model) << listed(read);
  EXPECT_EQ(read.files, (std::vector<fs::path>{"crate.obj", "a.mtl", "b.mtl"}));
}

}  // namespace
}  // namespace hearth
