#include <gtest/gtest.h>

#include <array>
#include <set>

#include "cli/command.h"
#include "cli/info/format_features.h"
#include "loaded.h"
#include "settings/options.h"

namespace hearth {

namespace {

TEST(Options, EveryRowIsFoundUnderItsOwnNumber) {
  const auto last = static_cast<int>(Option::MaxSpriteImages);
  std::set<std::string_view> names;
  for (int i = 0; i <= last; ++i) names.insert(row(static_cast<Option>(i)).name);
  EXPECT_EQ(std::ssize(names), last + 1);
}

TEST(Options, SizesAreTwoWholeNumbersInRange) {
  EXPECT_EQ(parseSize("640x400")->width, 640);
  EXPECT_EQ(parseSize("1x16384")->height, 16384);
  for (const char* wrong : {"", "x", "640", "640x", "x400", "640x400x2", "0x1", "-1x1", "1x16385",
                            "6.4x4", " 1x1", "1x1 ", "99999999999x1"})
    EXPECT_FALSE(parseSize(wrong)) << wrong;
}

TEST(Options, NumbersAreFiniteAndWholeLists) {
  EXPECT_EQ(parseNumbers("1,-2.5,3e1"), (std::vector<double>{1, -2.5, 30}));
  for (const char* wrong : {"", ",", "1,", "1,,2", "1 2", "inf", "nan", "1e999", "0x10", "1;2"})
    EXPECT_FALSE(parseNumbers(wrong)) << wrong;
}

TEST(FormatFeatures, NamesStandInTheOrderOfTheEnumeration) {
  for (std::size_t i = 0; i < kFormatFeatures.size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(kFormatFeatures[i].feature), i) << kFormatFeatures[i].name;
}

TEST(FormatFeatures, SectorsOverlapOnlyWhereTheyShareAir) {
  FeatureCounts counts;
  countGeometry(loaded("tests/levels/overlap.json").scene(), counts);
  // The two corridors, and the closet in one of them; the cellar only touches.
  EXPECT_EQ(counts[FormatFeature::OverlappingSectors], 2);
  FeatureCounts none;
  countGeometry(loaded("tests/levels/rooms.json").scene(), none);
  EXPECT_EQ(none[FormatFeature::OverlappingSectors], 0);
}

TEST(FormatFeatures, CommentsAreNotCounted) {
  FeatureCounts counts;
  const std::string room =
      R"({"floor": {"texture": "a"}, "$old": {"texture": "#000000"}, "loops": [
          {"v": [0,0, 1,0, 1,1], "// walls": [], "walls": {"texture": "b 2,2 1,1"}}]})";
  const std::string level = R"({"sectors": {"// was": )" + room + R"(, "room": )" + room + "}}";
  countSpellings(std::array<std::string_view, 1>{level}, counts);
  EXPECT_EQ(counts[FormatFeature::SolidWall], 1);
  EXPECT_EQ(counts[FormatFeature::TextureOffset], 1);
  EXPECT_EQ(counts[FormatFeature::PlainColour], 0);
}

}  // namespace

}  // namespace hearth
