#include "load/suggest.h"

#include <gtest/gtest.h>

#include <array>

namespace hearth {
namespace {

constexpr std::array<std::string_view, 3> kKnown{"floor", "ceiling", "light"};

TEST(EditDistance, countsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(editDistance("floor", "floor"), 0U);
  EXPECT_EQ(editDistance("flor", "floor"), 1U);
  EXPECT_EQ(editDistance("flooor", "floor"), 1U);
  EXPECT_EQ(editDistance("flaor", "floor"), 1U);
  EXPECT_EQ(editDistance("lfoor", "floor"), 1U);
  EXPECT_EQ(editDistance("", "abc"), 3U);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
}

TEST(Suggest, namesTheNearestUpToTwoEditsAway) {
  EXPECT_EQ(suggest("celling", kKnown, "x"), "did you mean \"ceiling\"?");
  EXPECT_EQ(suggest("lihgt", kKnown, "x"), "did you mean \"light\"?");
}

TEST(Suggest, namesTheOneThatWasCutShort) {
  constexpr std::array<std::string_view, 4> kKeys{"texture", "next", "walls", "wall-light"};
  EXPECT_EQ(nearestName("tex", kKeys), "texture");
  EXPECT_EQ(nearestName("te", kKeys), std::nullopt);
  EXPECT_EQ(nearestName("wall", kKeys), "walls");
}

TEST(Suggest, listsFewNamesWhenNoneIsNear) {
  EXPECT_EQ(suggest("walls", kKnown, "x"), "use one of: floor, ceiling, light");
  EXPECT_EQ(suggest("walls", {}, "remove it"), "remove it");
}

TEST(Suggest, doesNotTakeAnotherWordOfTwoLettersForASlip) {
  constexpr std::array<std::string_view, 2> kShort{"up", "x"};
  EXPECT_EQ(nearestName("zz", kShort), std::nullopt);
  EXPECT_EQ(nearestName("y", kShort), std::nullopt);
  EXPECT_EQ(nearestName("ub", kShort), "up");
}

}  // namespace
}  // namespace hearth
