#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "load/model/model_report.h"
#include "memory_model.h"
#include "support/temporary_folder.h"

/// What is wrong with OBJ and MTL files, and what of them is left out.
namespace hearth {
namespace {

/// All messages of a text that is refused.
std::string refused(const std::string& obj, const std::string& mtl = "",
                    const LoadLimits& limits = {}) {
  const ModelRead read = readObj(obj, mtl, limits);
  EXPECT_FALSE(read.model);
  return listed(read);
}

/// All messages of a text that is taken.
std::string warned(const std::string& obj, const std::string& mtl = "") {
  const ModelRead read = readObj(obj, mtl);
  EXPECT_TRUE(read.model) << listed(read);
  return listed(read);
}

const std::string kTriangle = kSquareVertices + "f 1 2 3\n";
const std::string kWorn = "mtllib crate.mtl\nusemtl a\n" + kTriangle;

TEST(ModelMistakes, numbersThatAreNone) {
  for (const std::string wrong : {"one", "1,5", "0x1", "nan", "1.2.3"}) {
    EXPECT_EQ(refused("v 0 0 0\nv 1 " + wrong + " 0\nv 0 1 0\nf 1 2 3\n"),
              "crate.obj:2: error: \"" + wrong + "\" is no number, write it like 1.25 or -3e-5\n");
    EXPECT_EQ(refused(kTriangle + "vt 0 " + wrong + "\n"),
              "crate.obj:6: error: \"" + wrong + "\" is no number, write it like 1.25 or -3e-5\n");
  }
}

TEST(ModelMistakes, numbersOutOfRange) {
  for (const std::string wrong : {"inf", "-inf", "1e999", "-1e999", "1000000001", "-1.1e9"})
    EXPECT_EQ(refused("v 0 0 0\nv 1 1 " + wrong + "\nv 0 1 0\nf 1 2 3\n"),
              "crate.obj:2: error: " + wrong +
                  " is out of range, give a number from -1000000000 to 1000000000\n");
  EXPECT_TRUE(readObj("v 0 0 0\nv 1 1 1e9\nv 0 1 -1e9\nf 1 2 3\n").model);
}

TEST(ModelMistakes, tooFewNumbers) {
  EXPECT_EQ(refused("v 0 0 0\nv 1 1\nv 0 1 0\nf 1 2 3\n"),
            "crate.obj:2: error: \"v\" has too few numbers, give x, y and z\n");
  EXPECT_EQ(refused(kTriangle + "vt\n"),
            "crate.obj:6: error: \"vt\" has too few numbers, give u and v\n");
}

TEST(ModelMistakes, cornersThatAreNone) {
  for (const std::string wrong :
       {"x", "1.0", "/1", "//1", "1/x", "1//x", "1/1/1/1", "1/1/1/", "+1"})
    EXPECT_EQ(
        refused(kSquareVertices + "vt 0 0\nf 1 2 " + wrong + "\n"),
        "crate.obj:6: error: \"" + wrong +
            "\" is no corner of a face, write V, V/VT, V//VN or V/VT/VN with whole numbers\n");
}

TEST(ModelMistakes, cornersAtVerticesThatAreNotThere) {
  const std::string advice = ", count them from 1, or with -1 for the last one before the line\n";
  for (const std::string wrong : {"0", "5", "99999999999999999999"})
    EXPECT_EQ(refused(kSquareVertices + "f 1 2 " + wrong + "\n"),
              "crate.obj:5: error: there is no vertex " + wrong + ": the file has 4" + advice);
  for (const std::string wrong : {"-5", "-9223372036854775808", "-99999999999999999999"})
    EXPECT_EQ(
        refused(kSquareVertices + "f 1 2 " + wrong + "\nv 9 9 9\n"),
        "crate.obj:5: error: there is no vertex " + wrong + ": 4 stand before this line" + advice);
  EXPECT_EQ(refused(kSquareVertices + "vt 0 0\nf 1 2/1 3/2\n"),
            "crate.obj:6: error: there is no texture vertex 2: the file has 1" + advice);
  EXPECT_EQ(refused(kSquareVertices + "f 1/-1 2 3\n"),
            "crate.obj:5: error: there is no texture vertex -1: 0 stand before this line" + advice);
}

TEST(ModelMistakes, facesOfTooFewCorners) {
  EXPECT_EQ(refused(kTriangle + "f\nf 1\nf 1 2\n"),
            "crate.obj:6: error: a face of 0 corner(s), give it at least three\n"
            "crate.obj:7: error: a face of 1 corner(s), give it at least three\n"
            "crate.obj:8: error: a face of 2 corner(s), give it at least three\n");
}

TEST(ModelMistakes, noFaces) {
  const std::string message =
      "crate.obj:0: error: no faces, export the model as polygons: lines that begin with \"f\"\n";
  EXPECT_EQ(refused(""), message);
  EXPECT_EQ(refused(kSquareVertices), message);
  EXPECT_EQ(refused(kSquareVertices + "l 1 2\n"),
            message +
                "crate.obj:5: warning: left out: l (line 5), only v, vt, f, usemtl and mtllib "
                "are read\n");
}

TEST(ModelMistakes, facesWithoutArea) {
  const std::string vertices = "v 0 0 0\nv 1 1 1\nv 3 3 3\nv 0 1 0\nv 1e-200 0 0\nv 0 1e-200 0\n";
  const std::string advice = ", give faces corners that are not in one line\n";
  EXPECT_EQ(refused(vertices + "f 1 2 3\n"), "crate.obj:7: error: no face has an area" + advice);
  EXPECT_EQ(refused(vertices + "f 1 2 2\n"), "crate.obj:7: error: no face has an area" + advice);
  EXPECT_EQ(refused(vertices + "f 1 5 6\n"), "crate.obj:7: error: no face has an area" + advice);
  const ModelRead read = readObj(vertices + "f 1 2 4\nf 1 2 3 4\nf 4 4 1\n");
  EXPECT_EQ(listed(read),
            "crate.obj:8: warning: left out: 2 triangle(s) without area, of 4" + advice);
  ASSERT_TRUE(read.model);
  ASSERT_EQ(read.model->faces.size(), 2U);
  EXPECT_EQ(read.model->faces[1].corners[1], (Vec3{3, 3, 3}));
}

TEST(ModelMistakes, keywordsThatAreLeftOutAreToldOnceForEachFile) {
  EXPECT_EQ(warned("mtllib crate.mtl\no crate\nvn 0 0 1\n" + kTriangle + "vn 0 0 1\ns off\no b\n",
                   "newmtl a\nNs 10\nKa 1 1 1\nNs 10\nmap_Kd -s 2 2 2 a.png\nillum 2\n"),
            "crate.obj:2: warning: left out: o (line 2), vn (line 3), s (line 10), "
            "only v, vt, f, usemtl and mtllib are read\n"
            "crate.mtl:2: warning: left out: Ns (line 2), Ka (line 3), options of map_Kd (line 5), "
            "illum (line 6), only newmtl, Kd and map_Kd are read\n");
}

TEST(ModelMistakes, numbersThatAreLeftOutAreToldOnceForEachFile) {
  EXPECT_EQ(warned("mtllib crate.mtl\ns off\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nvt 0\n"
                   "vt 0 0\nvt 0 0 x\nvt 0 0 0\nf 1 2 3\n",
                   "newmtl a\nKd 1 1 1\nKd 0.5\nKd 0.5 0.5 0.5 0.5\n"),
            "crate.obj:2: warning: left out: s (line 2), more numbers of v (line 3), "
            "more numbers of vt (line 8), only v, vt, f, usemtl and mtllib are read\n"
            "crate.mtl:4: warning: left out: more numbers of Kd (line 4), "
            "only newmtl, Kd and map_Kd are read\n");
}

TEST(ModelMistakes, ofManyKeywordsTheFirstOnesAreTold) {
  std::string text = kTriangle;
  for (int i = 0; i < 1000; ++i) text += fmt::format("word{}\n", i);
  text += std::string(100'000, 'x') + "\n";
  const std::string message = warned(text);
  EXPECT_NE(message.find("word15 (line 21) and more, only"), std::string::npos) << message;
  EXPECT_EQ(message.find("word16"), std::string::npos) << message;
}

TEST(ModelMistakes, aFileThatIsNotThere) {
  test::MemoryFiles files;
  const auto told = [&](const std::filesystem::path& file) {
    const ModelRead read = readModel(file, {}, files);
    EXPECT_FALSE(read.model);
    EXPECT_TRUE(read.files.empty());
    return listed(read);
  };
  EXPECT_EQ(told("models/crate.obj"), "crate.obj:0: error: no such file, name an OBJ file\n");
  files.add("models/crates.obj", "");
  EXPECT_EQ(told("models/crate.obj"),
            "crate.obj:0: error: no such file, did you mean models/crates.obj?\n");
  EXPECT_NE(told(std::string("models/crates.obj\0.png", 22)).find("error: no such file"),
            std::string::npos);
}

TEST(ModelMistakes, filesThatTheDiskRefuses) {
  const test::TemporaryFolder folder;
  EXPECT_NE(listed(readModel(folder.path(), {})).find(":0: error: not a regular file, name an OBJ"),
            std::string::npos);
  const auto file =
      folder.write("crate.obj", "mtllib .\nmtllib " + std::string(4000, 'a') + "\n" + "mtllib " +
                                    std::string(5000, 'a') + "\n" + kTriangle);
  const std::string told = listed(readModel(file, {}));
  EXPECT_NE(told.find("crate.obj:1: error: "), std::string::npos) << told;
  EXPECT_NE(told.find("not a regular file"), std::string::npos) << told;
  EXPECT_NE(told.find("crate.obj:2: error: "), std::string::npos) << told;
  EXPECT_NE(told.find("aaa...\" has 5000 bytes, give the file a name of at most 4096"),
            std::string::npos)
      << told;
}

TEST(ModelMistakes, aFileThatIsTooLong) {
  LoadLimits limits;
  limits.fileBytes = kTriangle.size();
  EXPECT_TRUE(readObj(kTriangle, "", limits).model);
  --limits.fileBytes;
  EXPECT_EQ(refused(kTriangle, "", limits),
            "crate.obj:0: error: too long, raise the limit with --max-file-bytes\n");
}

TEST(ModelMistakes, materialsThatAreTooLongTogether) {
  test::MemoryFiles files;
  files.add("crate.obj", "mtllib a.mtl\nmtllib b.mtl\n" + kTriangle);
  files.add("a.mtl", std::string(60, '\n'));
  files.add("b.mtl", std::string(60, '\n'));
  LoadLimits limits;
  limits.fileBytes = 120;
  EXPECT_TRUE(readModel("crate.obj", limits, files).model);
  limits.fileBytes = 119;
  EXPECT_EQ(listed(readModel("crate.obj", limits, files)),
            "crate.obj:2: error: b.mtl: too long, raise the limit with --max-file-bytes\n");
}

TEST(ModelMistakes, whatIsNoText) {
  const std::string message = "not a text: it has zero bytes, save it as UTF-8\n";
  EXPECT_EQ(refused(kTriangle + std::string(1, '\0')), "crate.obj:0: error: " + message);
  EXPECT_EQ(refused("mtllib crate.mtl\n" + kTriangle, std::string(1, '\0')),
            "crate.obj:1: error: models/crate.mtl: " + message);
}

TEST(ModelMistakes, aFileOfMaterialsThatIsNotThereExplainsMissingOnes) {
  EXPECT_EQ(refused("\nmtllib create.mtl\nusemtl a\n" + kTriangle),
            "crate.obj:2: error: models/create.mtl: no such file, "
            "did you mean models/crate.mtl?\n");
  EXPECT_EQ(refused("mtllib my crate.mtl\n" + kTriangle),
            "crate.obj:1: error: models/my: no such file, correct the name, which is relative to "
            "the folder of this file and ends at the first blank\n");
  EXPECT_EQ(refused("mtllib\n" + kTriangle),
            "crate.obj:1: error: \"mtllib\" without a file, name a file, or remove it\n");
}

TEST(ModelMistakes, moreFilesOfMaterialsThanAnAuthorNames) {
  test::MemoryFiles files;
  std::string text = kTriangle;
  for (int i = 0; i < 70; ++i) {
    files.add(fmt::format("{}.mtl", i), "");
    text += fmt::format("mtllib {}.mtl 0.mtl\n", i);
  }
  files.add("crate.obj", text);
  const ModelRead read = readModel("crate.obj", {}, files);
  EXPECT_EQ(listed(read),
            "crate.obj:70: error: more than 64 files of materials, put the materials into one "
            "file\n");
  EXPECT_EQ(read.files.size(), 65U);
}

TEST(ModelMistakes, materialsThatAreNotThere) {
  EXPECT_EQ(refused("usemtl wod\n" + kTriangle + "mtllib crate.mtl\n", "newmtl wood\nnewmtl tin\n"),
            "crate.obj:1: error: there is no material \"wod\", did you mean \"wood\"?\n");
  EXPECT_EQ(refused("usemtl a\n" + kTriangle),
            "crate.obj:1: error: there is no material \"a\", "
            "name with \"mtllib\" a file that has it, or correct the name\n");
  EXPECT_EQ(refused("usemtl\n" + kTriangle),
            "crate.obj:1: error: \"usemtl\" without a name, name a material, or remove it\n");
}

TEST(ModelMistakes, inMaterials) {
  EXPECT_EQ(refused(kWorn, "newmtl a\nKd 1 1.01 0\nKd -0.1\nKd 0 0\nKd spectral a.rfl\nmap_Kd\n"),
            "crate.mtl:2: error: 1.01 is out of range, give a number from 0 to 1\n"
            "crate.mtl:3: error: -0.1 is out of range, give a number from 0 to 1\n"
            "crate.mtl:4: error: \"Kd\" has too few numbers, give red, green and blue\n"
            "crate.mtl:5: error: \"spectral\" is no number, write it like 1.25 or -3e-5\n"
            "crate.mtl:6: error: \"map_Kd\" without a file, name an image\n");
  EXPECT_EQ(refused(kWorn, "newmtl a\nnewmtl b\nnewmtl a\nKd 0 0 0\n"),
            "crate.mtl:3: error: two materials are named \"a\", rename one of them\n");
  EXPECT_EQ(refused(kWorn, "Kd 0 0 0\nnewmtl a\nnewmtl\nKd 0 0 0\n"),
            "crate.mtl:1: error: \"Kd\" outside a material, begin a material with "
            "\"newmtl NAME\"\n"
            "crate.mtl:3: error: \"newmtl\" without a name, give the material one\n");
}

TEST(ModelMistakes, moreFacesThanTheLimit) {
  LoadLimits limits;
  limits.meshFaces = 3;
  EXPECT_TRUE(readObj(kTriangle + "f 1 2 3 4\n", "", limits).model);
  EXPECT_EQ(refused(kTriangle + "f 1 2 3 4\nf 1 1 1\nf 1 2 3\n", "", limits),
            "crate.obj:7: error: more than 3 triangles, raise the limit with --max-mesh-faces\n");
  std::string fan = "f";
  while (fan.size() < 10'000'000) fan += " 1";
  EXPECT_EQ(
      refused(kSquareVertices + fan + "\n"),
      "crate.obj:5: error: more than 4000000 triangles, raise the limit with --max-mesh-faces\n");
}

TEST(ModelMistakes, standInTheOrderOfFilesAndLines) {
  EXPECT_EQ(
      refused("f 1 2 9\nv 0 0\nv 0 0 0\nmtllib crate.mtl\no a\nv 0 0 x\nusemtl b\nf 1 2 3\n",
              "newmtl a\nKd x\nNs 0\n"),
      "crate.obj:1: error: there is no vertex 9: the file has 3, count them from 1, or with "
      "-1 for the last one before the line\n"
      "crate.obj:2: error: \"v\" has too few numbers, give x, y and z\n"
      "crate.obj:5: warning: left out: o (line 5), only v, vt, f, usemtl and mtllib are read\n"
      "crate.obj:6: error: \"x\" is no number, write it like 1.25 or -3e-5\n"
      "crate.obj:7: error: there is no material \"b\", use one of: a\n"
      "crate.mtl:2: error: \"x\" is no number, write it like 1.25 or -3e-5\n"
      "crate.mtl:3: warning: left out: Ns (line 3), only newmtl, Kd and map_Kd are read\n");
}

TEST(ModelMistakes, ofThousandsTheFirstOnesOfEachFileAreTold) {
  std::string vertices;
  std::string faces;
  std::string colors;
  for (int i = 0; i < 5000; ++i) {
    vertices += "v x\n";
    faces += "f 9\n";
    colors += "Kd x\n";
  }
  for (const std::string& obj : {kWorn + vertices, kWorn + faces}) {
    const ModelRead read = readObj(obj, "newmtl a\n" + colors);
    EXPECT_FALSE(read.model);
    ASSERT_EQ(read.mistakes.size(), 2 * (ModelReport::kMaxErrors + 1));
    for (const std::size_t last : {ModelReport::kMaxErrors, 2 * ModelReport::kMaxErrors + 1})
      EXPECT_EQ(read.mistakes[last].message, "more errors; the file is not read to its end");
  }
}

TEST(ModelMistakes, longNamesAreToldShort) {
  const std::string name(1'000'000, 'n');
  for (const std::string& text :
       {"usemtl " + name, "v " + name, "f " + name, "mtllib " + name, name + " 1"}) {
    const ModelRead read = readObj(kTriangle + text + "\n");
    ASSERT_EQ(read.mistakes.size(), 1U) << text.substr(0, 9);
    EXPECT_LT(read.mistakes[0].message.size() + read.mistakes[0].advice.size(), 300U);
  }
  EXPECT_LT(refused(kWorn, "newmtl " + name).size(), 300U);
}

TEST(ModelMistakes, strayBytesNeverStopTheProgram) {
  const std::string obj = "mtllib crate.mtl\n" + kSquareVertices +
                          "vt 0 0.5\nusemtl a\nf 1/1 2//1 3/1/1 \\\n 4\nf -1 -2 -3 # end\n";
  const std::string mtl = "newmtl a\nKd 0.5 1 0\nmap_Kd -s 1 1 1 a.png\n";
  const auto expectTold = [](const ModelRead& read) {
    const bool hasErrors = std::ranges::any_of(read.mistakes, &ModelMistake::isError);
    EXPECT_NE(read.model.has_value(), hasErrors) << listed(read);
  };
  for (const char byte : {'\0', ' ', '\n', '\\', '/', '#', '9', '-', 'e', '\x80', '\xff'}) {
    for (std::size_t i = 0; i < obj.size(); ++i) {
      std::string changed = obj;
      changed[i] = byte;
      expectTold(readObj(changed, mtl));
      expectTold(readObj(obj.substr(0, i) + byte, mtl));
    }
    for (std::size_t i = 0; i < mtl.size(); ++i) {
      std::string changed = mtl;
      changed[i] = byte;
      expectTold(readObj(obj, changed));
    }
  }
}

}  // namespace
}  // namespace hearth
