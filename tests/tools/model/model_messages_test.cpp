// What is told of a model that is looked at alone.

#include <gtest/gtest.h>

#include <string>

#include "opened_model.h"

namespace hearth {
namespace {

using test::boxModel;
using test::listed;
using test::opened;

TEST(ModelMessages, NameTheFileThatIsMissing) {
  EXPECT_EQ(listed(openLevel("no/such/crate.obj", {}, {}, test::MemoryFiles())),
            "no/such/crate.obj:1:1: error: no such file, name an OBJ file\n");
}

TEST(ModelMessages, NameTheLinesOfTheModelsFiles) {
  EXPECT_EQ(listed(opened("v 0 0 0\nv 1 0 zero\nv 0 1 0\n\nf 1 2\n")),
            "models/crate.obj:2:1: error: \"zero\" is no number, write it like 1.25 or -3e-5\n"
            "models/crate.obj:5:1: error: a face of 2 corner(s), give it at least three\n");
  EXPECT_EQ(
      listed(opened("mtllib crate.mtl\nusemtl wood\n" + boxModel(1), "newmtl wood\nKd 1 0 blue\n")),
      "models/crate.mtl:2:1: error: \"blue\" is no number, write it like 1.25 or -3e-5\n");
}

TEST(ModelMessages, TellOnceWhatIsLeftOut) {
  const OpenedLevel level = opened("o crate\ns off\n" + boxModel(1));
  EXPECT_TRUE(level.result.loaded);
  EXPECT_EQ(
      listed(level),
      "models/crate.obj:1:1: warning: left out: o (line 1), s (line 2), only v, vt, f, usemtl "
      "and mtllib are read [model-skips]\n");
}

TEST(ModelMessages, RefuseAnEmptyModel) {
  const std::string advice = "export the model as polygons: lines that begin with \"f\"\n";
  EXPECT_EQ(listed(opened("")), "models/crate.obj:1:1: error: no faces, " + advice);
  EXPECT_EQ(listed(opened("v 0 0 0\n")), "models/crate.obj:1:1: error: no faces, " + advice);
}

TEST(ModelMessages, NameTheModelWhoseImageIsMissing) {
  const OpenedLevel level =
      opened("mtllib crate.mtl\nusemtl wood\n" + boxModel(1), "newmtl wood\nmap_Kd no.png\n");
  EXPECT_FALSE(level.result.loaded);
  EXPECT_EQ(listed(level).substr(0, 30), "models/crate.obj:1:1: error: t");
  EXPECT_NE(listed(level).find("no.png"), std::string::npos);
  EXPECT_EQ(listed(level).find("air.json"), std::string::npos);
  EXPECT_EQ(listed(level).find("/things"), std::string::npos);
}

TEST(ModelMessages, RefuseWhatIsTooSmallOrTooLarge) {
  EXPECT_EQ(listed(opened(boxModel(1e-6))),
            "models/crate.obj:1:1: error: the model is only 1.73e-06 m large, scale it up in the "
            "program that made it: a unit is a metre\n");
  EXPECT_EQ(listed(opened(boxModel(1e8))),
            "models/crate.obj:1:1: error: the model is 1.73e+08 m large, and reaches to (5e+07, "
            "1e+08, 5e+07): with the air round it that is beyond 1e+09 m, scale it down in the "
            "program that made it, or move it to its origin: a unit is a metre\n");
  EXPECT_FALSE(opened(boxModel(1, 9.9999999e8)).result.loaded);
}

TEST(ModelMessages, WarnOfModelsFarFromTheirOrigin) {
  const OpenedLevel level = opened(boxModel(1, 3e7));
  EXPECT_TRUE(level.result.loaded);
  EXPECT_EQ(listed(level),
            "models/crate.obj:1:1: warning: the model reaches 3e+07 m from its origin: light may "
            "miss its faces, move it to within 10000000 m of its origin [far-away]\n");
  EXPECT_EQ(listed(opened(boxModel(1e6))), "") << "its air may reach beyond that";
}

TEST(ModelMessages, RefuseANameThatNoLevelCanWrite) {
  EXPECT_EQ(listed(opened(boxModel(1), "", "models/caf\xe9.obj")),
            "models/caf\xe9.obj:1:1: error: the name of the file is not UTF-8, rename it\n");
  EXPECT_TRUE(opened(boxModel(1), "", "models/a \"b\\c.obj").result.loaded);
}

TEST(ModelMessages, KeepToTheUsersLimitsForTheModelAlone) {
  LoadLimits few;
  few.vertices = few.lights = 1;
  few.fileBytes = 400;
  EXPECT_TRUE(opened(boxModel(1), "", "models/crate.obj", few).result.loaded);
  few.meshFaces = 11;
  EXPECT_NE(listed(opened(boxModel(1), "", "models/crate.obj", few)).find("--max-mesh-faces"),
            std::string::npos);
}

}  // namespace
}  // namespace hearth
