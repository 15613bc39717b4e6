#include <gtest/gtest.h>

#include <array>
#include <set>

#include "cli/command.h"
#include "cli/info/format_features.h"
#include "loaded.h"
#include "settings/options.h"
#include "support/level_text.h"

namespace hearth {

namespace {

TEST(Options, EveryRowIsFoundUnderItsOwnNumber) {
  const auto last = static_cast<int>(Option::MaxMeshFaces);
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

TEST(FormatFeatures, OfGridsTheEntriesOfTheLegendAreCounted) {
  FeatureCounts counts;
  countSpellings(std::array<std::string_view, 1>{R"({"grid": {"rows": ["#.h"], "legend": {
      "#": {"wall": "a", "walls": {"n": "b 2,2", "// e": "c 2,2"}},
      ".": {"light": 0.5, "floor": {"texture": "#808080"}, "ceiling": {"texture": "a"}},
      "// old": {"wall": "#000000"},
      "h": {"next": "hall", "lower": "#404040"}}}})"},
                 counts);
  EXPECT_EQ(counts[FormatFeature::Grid], 1);
  EXPECT_EQ(counts[FormatFeature::GridSides], 1);
  EXPECT_EQ(counts[FormatFeature::GridNext], 1);
  EXPECT_EQ(counts[FormatFeature::SectorLight], 1);
  EXPECT_EQ(counts[FormatFeature::TextureScale], 1);
  EXPECT_EQ(counts[FormatFeature::PlainColour], 2);
}

TEST(FormatFeatures, SpritesAreCountedByWhatTheyAre) {
  const LoadedLevel level = test::levelFrom(
      "{'light': 1, 'things': ["
      "{'sprite': '#c04020', 'x': 1, 'y': 1, 'radius': 0.3, 'height': 1},"
      "{'sprite': ['#c04020', '#a04020'], 'x': 2, 'y': 1, 'bright': true},"
      "{'sprite': '#c04020', 'x': 3, 'y': 1, 'facing': 'angle'},"
      "{'frames': ['#c04020', '#a04020'], 'fps': 2, 'x': 1, 'y': 2, 'facing': 'flat'}],"
      "'sectors': {" +
      test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3) + "}}");
  FeatureCounts counts;
  countGeometry(level.scene(), counts);
  EXPECT_EQ(counts[FormatFeature::CameraSprite], 2);
  EXPECT_EQ(counts[FormatFeature::FixedSprite], 1);
  EXPECT_EQ(counts[FormatFeature::FlatSprite], 1);
  EXPECT_EQ(counts[FormatFeature::SolidSprite], 1);
  EXPECT_EQ(counts[FormatFeature::BrightSprite], 1);
  EXPECT_EQ(counts[FormatFeature::SpriteOfManySides], 1);
  EXPECT_EQ(counts[FormatFeature::AnimatedSprite], 1);
}

TEST(FormatFeatures, SpellingsOfThingsAreCounted) {
  FeatureCounts counts;
  const std::string level = R"({"sectors": {}, "things": [
      {"frames": ["flame", ["#ff0000", "#00ff00"]], "fps": 2, "x": 1, "y": 1, "sector": "a"},
      {"sprite": "#ff0000", "x": 1, "y": 1}]})";
  countSpellings(std::array<std::string_view, 1>{level}, counts);
  EXPECT_EQ(counts[FormatFeature::PlainColour], 3);
  EXPECT_EQ(counts[FormatFeature::PositionWithSector], 1);
  EXPECT_EQ(counts[FormatFeature::PositionWithoutSector], 1);
}

}  // namespace

}  // namespace hearth
