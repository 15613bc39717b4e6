#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>

#include "light/bakery.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

std::string mistakeIn(const BakeSettings& settings) {
  static const LoadedLevel room = test::levelFrom(
      "{'light': 0.1, 'sectors': {" + test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3) + "}}");
  return mistakeInSettings(room.scene(), settings).value_or("");
}

TEST(BakeSettings, ofAFileThatSaysNothingHaveNoMistake) { EXPECT_EQ(mistakeIn({}), ""); }

TEST(BakeSettings, takeSquareNumbersOfSamplesOrNone) {
  for (const std::optional<int> samples : {std::optional(1), std::optional(4096), {}})
    EXPECT_EQ(mistakeIn({.samples = samples}), "");
  EXPECT_EQ(mistakeIn({.samples = 8}), "samples: 8 is no square number, try 9");
  for (const int wrong : {0, -1, -4})
    EXPECT_TRUE(mistakeIn({.samples = wrong}).ends_with("is no square number, try 1")) << wrong;
}

TEST(BakeSettings, takeSquareNumbersOfSoftSamples) {
  for (const int right : {0, 1, 256}) EXPECT_EQ(mistakeIn({.softSamples = right}), "");
  EXPECT_EQ(mistakeIn({.softSamples = 60}), "soft-samples: 60 is no square number, try 64");
}

TEST(BakeSettings, takeGatherErrorsOfMoreThanNothing) {
  EXPECT_EQ(mistakeIn({.gatherError = 0.001}), "");
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(mistakeIn({.gatherError = wrong}).starts_with("gather-error: ")) << wrong;
}

TEST(BakeSettings, takeCutOffsFromNothingOn) {
  EXPECT_EQ(mistakeIn({.cutOff = 4}), "");
  for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(mistakeIn({.cutOff = wrong}).starts_with("cut-off: ")) << wrong;
}

TEST(BakeSettings, takeTexelsThatFitTheMemory) {
  EXPECT_EQ(mistakeIn({.texel = 0.01}), "");
  for (const double wrong : {0.0, -1.0, 1e-9, std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(mistakeIn({.texel = wrong}).starts_with("texel: ")) << wrong;
}

TEST(BakeSettings, countTexelsOfSurfacesAndNotOfSkies) {
  // A field of 90 km, with earth or with sky below.
  const auto fields = [](const char* floor) {
    return test::levelFrom(std::string("{'light':0.1,'sectors':{") + "'a':{'floor':" + floor +
                           ",'ceiling':{'z':10,'parallax':true,'texture':'#808080'},"
                           "'loops':{'border':{'v':[0,0,90000,0,90000,90000,0,90000],"
                           "'walls':{'texture':'#808080'}}}}}}");
  };
  const auto mistake = [&](const char* floor) {
    return mistakeInSettings(fields(floor).scene(), {}).value_or("");
  };
  EXPECT_EQ(mistake("{'parallax':true,'texture':'#808080'}"), "");
  EXPECT_TRUE(mistake("{'texture':'#808080'}").ends_with("use larger ones"));
}

TEST(BakeSettings, nameTheMeshThatTakesTheTexels) {
  const auto crate = [](std::string_view scale) {
    return test::levelFrom(
        fmt::format("{{'light':0.1,'sectors':{{'a':{{'floor':{{'texture':'#808080'}},"
                    "'ceiling':{{'texture':'#808080'}},'loops':{{'border':"
                    "{{'v':[0,0,4,0,4,4,0,4],'walls':{{'texture':'#808080'}}}}}}}}}},'things':["
                    "{{'mesh':'{}','name':'crate','x':1,'y':1,'scale':{}}}]}}",
                    test::inTree("levels/models/crate.obj").string(), scale));
  };
  EXPECT_EQ(mistakeInSettings(crate("1").scene(), {}), std::nullopt);
  EXPECT_TRUE(mistakeInSettings(crate("1e5").scene(), {})
                  .value_or("")
                  .ends_with("most of them on mesh crate: correct its scale, or use larger ones"));
}

}  // namespace
}  // namespace hearth
