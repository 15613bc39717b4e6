#include <fmt/format.h>
#include <gtest/gtest.h>

#include "places.h"
#include "support/in_tree.h"

namespace hearth::test {

namespace {

/// The text of a level, with the project's images. Bricks repeat after 1.6 m.
std::string withImages(std::string_view text) {
  return with(text, "FOLDER", test::inTree("textures").string());
}

/// A room whose north wall has two parts, 1 and 3 m long.
constexpr std::string_view kTwoWalls = R"({ 'light': 0.5, 'textures': 'FOLDER', 'sectors': {
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'z': 3.2, 'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 1,0, 4,0, 4,4, 0,4], 'walls': [
      {'texture': 'brick 1.6,1.6'},
      {'texture': 'brick 1.6,1.6'},
      {'texture': 'brick 1.6,1.6'},
      {'texture': 'brick 1.6,1.6'},
      {'texture': 'brick 1.6,1.6'}]}}}
}})";

TEST(TextureJumps, AreFoundAlongAPlaneAndNotRoundCorners) {
  EXPECT_EQ(placesOf(findTextureJumps, withImages(kTwoWalls)),
            (Places{"5:7 /sectors/room/loops/border/walls/1 [texture-jump]"}));
}

TEST(TextureJumps, AreMendedByWhatLiesBefore) {
  for (const char* along : {"1", "2.6", "-0.6"}) {
    const std::string wall = fmt::format(
        "'v': [0,0, 1,0, 4,0, 4,4, 0,4], 'walls': [\n"
        "      {{'texture': 'brick 1.6,1.6'}},\n"
        "      {{'texture': {{'name': 'brick', 'scale': [1.6, 1.6], "
        "'along': {}}}}},",
        along);
    const std::string mended =
        with(kTwoWalls,
             "'v': [0,0, 1,0, 4,0, 4,4, 0,4], 'walls': [\n      {'texture': 'brick 1.6,1.6'},\n"
             "      {'texture': 'brick 1.6,1.6'},",
             wall);
    EXPECT_EQ(placesOf(findTextureJumps, withImages(mended)), Places{}) << along;
  }
}

TEST(TextureJumps, AreNoneBetweenDifferentImagesOrPlainColours) {
  for (const char* texture : {"stone 1.6,1.6", "brick 1.5,1.6", "#a04020"}) {
    const std::string level = with(kTwoWalls, "[\n      {'texture': 'brick 1.6,1.6'}",
                                   "[\n      {'texture': '" + std::string(texture) + "'}");
    EXPECT_EQ(placesOf(findTextureJumps, withImages(level)), Places{}) << texture;
  }
}

TEST(TextureJumps, AreNoneThatCannotBeSeen) {
  const std::string_view brick = "brick 1.6,1.6";
  std::string level(kTwoWalls);
  for (std::size_t at = 0; (at = level.find(brick, at)) != std::string::npos;)
    level.replace(at, brick.size(), "plaster 1.6,1.6");
  EXPECT_EQ(placesOf(findTextureJumps, withImages(level)), Places{});
}

/// A wall beside a window: the piece below it hangs from the sill, 0.9 m up.
constexpr std::string_view kWindow = R"({ 'light': 0.5, 'textures': 'FOLDER', 'sectors': {
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'z': 3.2, 'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 1.6,0, 4,0, 4,4, 0,4], 'walls': [
      {'texture': 'brick 1.6,1.6'},
      {'walls': [
        {'z': 0.9, 'texture': 'brick 1.6,1.6'},
        {'z': 2, 'texture': '#4080ff'},
        {'texture': '#808080'}]},
      {'texture': '#808080'},
      {'texture': '#808080'},
      {'texture': '#808080'}]}}}
}})";

TEST(TextureJumps, AreFoundInTheHeightAtWhichAnImageHangs) {
  EXPECT_EQ(placesOf(findTextureJumps, withImages(kWindow)),
            (Places{"6:9 /sectors/room/loops/border/walls/1/walls/0 [texture-jump]"}));
}

TEST(TextureJumps, AreMendedByTheHeightOfTheNeighbour) {
  const std::string mended =
      with(kWindow, "{'z': 0.9, 'texture': 'brick 1.6,1.6'}",
           "{'z': 0.9, 'texture': {'name': 'brick', 'scale': [1.6, 1.6], 'zref': 3.2}}");
  EXPECT_EQ(placesOf(findTextureJumps, withImages(mended)), Places{});
}

TEST(TextureJumps, AreNoneBetweenHeightsThatBothWereWrittenDown) {
  const std::string_view wall = "0,4], 'walls': [\n      {'texture': 'brick 1.6,1.6'}";
  const std::string_view piece = "{'z': 0.9, 'texture': 'brick 1.6,1.6'}";
  const std::string hung = "{'name': 'brick', 'scale': [1.6, 1.6], 'zref': ";
  const std::string one = with(kWindow, piece, "{'z': 0.9, 'texture': " + hung + "0.9}}");
  EXPECT_EQ(placesOf(findTextureJumps, withImages(one)).size(), 1U);
  const std::string both = with(one, wall, "0,4], 'walls': [\n      {'texture': " + hung + "3.2}}");
  EXPECT_EQ(placesOf(findTextureJumps, withImages(both)), Places{});
}

/// The `"texture": { .. }` of each piece of advice.
std::vector<std::string> advisedTextures(std::string_view level) {
  std::vector<std::string> textures;
  for (const std::string& advice : advicesOf(findTextureJumps, level)) {
    const std::size_t begin = advice.find('"');
    textures.push_back(advice.substr(begin, advice.rfind('}') + 1 - begin));
  }
  return textures;
}

TEST(TextureJumps, EndWithTheHeightThatIsAdvised) {
  const std::string window = withImages(kWindow);
  const std::vector<std::string> advised = advisedTextures(window);
  ASSERT_EQ(advised, std::vector<std::string>{
                         R"("texture": { "name": "brick", "scale": [1.6, 1.6], "zref": 3.2 })"});
  const std::string mended =
      with(window, "'z': 0.9, 'texture': 'brick 1.6,1.6'", "'z': 0.9, " + advised.front());
  EXPECT_EQ(placesOf(findTextureJumps, mended), Places{});
}

/// A room whose north wall has three parts, 1, 0.9 and 2.1 m long; what the last two wear.
std::string rowOfWalls(const std::string& second, const std::string& third) {
  return withImages(R"({ 'light': 0.5, 'textures': 'FOLDER', 'sectors': {
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'z': 3.2, 'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 1,0, 1.9,0, 4,0, 4,4, 0,4], 'walls': [
      {'texture': {'name': 'brick', 'scale': [1.6, 1.6], 'along': 0.3}},
      {)" + second + R"(},
      {)" + third + R"(},
      {'texture': '#808080'},
      {'texture': '#808080'},
      {'texture': '#808080'}]}}}
}})");
}

TEST(TextureJumps, OfARowOfWallsEndTogetherWithTheTexturesThatAreAdvised) {
  const std::vector<std::string> advised = advisedTextures(rowOfWalls(
      "'texture': 'brick 1.6,1.6 8,0'", "'texture': {'name': 'brick', 'scale': [1.6, 1.6]}"));
  ASSERT_EQ(advised.size(), 2U);
  EXPECT_EQ(advised[1], R"("texture": { "name": "brick", "scale": [1.6, 1.6], "along": 0.6 })");
  EXPECT_EQ(placesOf(findTextureJumps, rowOfWalls(advised[0], advised[1])), Places{});
}

/// A flight of three steps; on its south side the walls run from the last sector to the first.
std::string flightOfSteps(const std::vector<std::string>& textures) {
  const auto step = [&](int i, const std::string& east, const std::string& west) {
    return fmt::format(
        "'step-{0}': {{ 'floor': {{'z': {1:.1f}, 'texture': '#808080'}}, 'ceiling': {{'z': 3.2, "
        "'texture': '#808080'}}, 'loops': {{'border': {{'v': [{0},0, {2},0, {2},4, {0},4], "
        "'walls': [\n{{'texture': '#808080'}},\n{{{3}}},\n{{{4}}},\n{{{5}}}]}}}}}}",
        i, 0.2 * i, i + 1, east, textures[static_cast<std::size_t>(i)], west);
  };
  const std::string wall = "'texture': '#707070'";
  const std::string up = ", 'lower': '#606060'";
  return withImages(fmt::format(
      "{{ 'light': 0.5, 'textures': 'FOLDER', 'sectors': {{\n{},\n{},\n{}}}}}",
      step(0, "'next': 'step-1'" + up, wall), step(1, "'next': 'step-2'" + up, "'next': 'step-0'"),
      step(2, wall, "'next': 'step-1'")));
}

TEST(TextureJumps, OfAFlightOfStepsEndTogetherWhateverTheOrderOfItsSectors) {
  const std::string brick = "'texture': 'brick 1.6,1.6'";
  const std::vector<std::string> advised = advisedTextures(flightOfSteps({brick, brick, brick}));
  ASSERT_EQ(advised.size(), 2U);
  EXPECT_EQ(placesOf(findTextureJumps, flightOfSteps({advised[0], advised[1], brick})), Places{});
}

TEST(TextureJumps, AreAdvisedAWallOfTheirOwnWhereOneStandsForAll) {
  const std::string level = withImages(R"({ 'light': 0.5, 'textures': 'FOLDER', 'sectors': {
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'z': 3.2, 'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 1,0, 4,0, 4,4, 0,4], 'walls': {'texture': 'brick 1.6,1.6'}}}}
}})");
  EXPECT_EQ(advicesOf(findTextureJumps, level),
            std::vector<std::string>{
                "give each wall its own, and this one \"texture\": { \"name\": \"brick\", "
                "\"scale\": [1.6, 1.6], \"along\": 1 }"});
}

/// A step up to the dais, and no other.
constexpr std::string_view kDais = R"({ 'light': 0.5, 'sectors': {
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 4,0, 4,4, 0,4], 'walls': [
      {'texture': '#808080'},
      {'next': 'dais', 'lower': '#606060', 'upper': '#707070'},
      {'texture': '#808080'},
      {'texture': '#808080'}]}}},
  'dais': { 'floor': {'z': 0.3, 'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
    'loops': {'border': {'v': [4,0, 8,0, 8,4, 4,4], 'walls': [
      {'texture': '#808080'},
      {'texture': '#808080'},
      {'texture': '#808080'},
      {'next': 'room'}]}}}
}})";

TEST(UnseenTextures, AreThoseOfStepsThatAreNotThere) {
  EXPECT_EQ(placesOf(findUnseenTextures, kDais),
            (Places{"5:53 /sectors/room/loops/border/walls/1/upper [unseen-texture]"}));
  EXPECT_EQ(firstMessage(findUnseenTextures, kDais),
            "this \"upper\" never shows: the ceiling of sector \"dais\" is not lower");
}

TEST(UnseenTextures, AreNoneOnceTheStepIsThere) {
  EXPECT_EQ(placesOf(findUnseenTextures, with(kDais, ", 'upper': '#707070'", "")), Places{});
  const std::string lower = with(kDais, "'z': 0.3, 'texture': '#808080'}, 'ceiling': {",
                                 "'z': 0.3, 'texture': '#808080'}, 'ceiling': {'z': 3.5, ");
  EXPECT_EQ(placesOf(findUnseenTextures, lower), Places{});
}

TEST(UnseenTextures, AreThoseThatHangBesideTheirOpening) {
  const auto hung = [](const std::string& zref) {
    return with(kDais, "'upper': '#707070'", "'middle': {'name': '#707070', 'zref': " + zref + "}");
  };
  EXPECT_EQ(placesOf(findUnseenTextures, hung("0.3")),
            (Places{"5:63 /sectors/room/loops/border/walls/1/middle/name [unseen-texture]"}));
  EXPECT_EQ(firstMessage(findUnseenTextures, hung("9")),
            "this \"middle\" never shows: none of it hangs in an opening to sector \"dais\"");
  EXPECT_EQ(placesOf(findUnseenTextures, hung("0.4")), Places{});
}

TEST(UnseenTextures, MayBeGivenToBothStepsForTheSakeOfOne) {
  const std::string both =
      with(kDais, "'lower': '#606060', 'upper': '#707070'", "'texture': '#606060'");
  EXPECT_EQ(placesOf(findUnseenTextures, both), Places{});
  EXPECT_EQ(placesOf(findUnseenTextures, with(both, "{'z': 0.3, 'texture'", "{'z': 0, 'texture'")),
            (Places{"5:35 /sectors/room/loops/border/walls/1/texture [unseen-texture]"}));
}

TEST(UnseenTextures, AreNoneInAClosedDoor) {
  const std::string closed =
      with(with(kDais, "'ceiling': {'texture': '#808080'},\n    'loops': {'border': {'v': [4,0",
                "'ceiling': {'z': 0.3, 'texture': '#808080'},\n    'loops': {'border': {'v': [4,0"),
           "{'next': 'room'}", "{'next': 'room', 'lower': '#808080'}");
  EXPECT_EQ(placesOf(findUnseenTextures, closed), Places{});
}

TEST(UnseenTextures, AreNoneBesideMovers) {
  const std::string flush = with(kDais, "{'z': 0.3, 'texture'", "{'z': 0, 'texture'");
  EXPECT_NE(placesOf(findUnseenTextures, flush), Places{});
  const std::string lift = "'movers': {'lift': {'sectors': 'dais', 'part': 'floor', 'to': 1}},";
  EXPECT_EQ(placesOf(findUnseenTextures, with(flush, "'sectors':", lift + " 'sectors':")),
            Places{});
}

TEST(UnseenTextures, AreNoneWhereAWedgeHidesTheStep) {
  const std::string wedge =
      with(kDais, "'room': {",
           "'room': { 'slopeFloor': {'z': [0, 0.5, 0.5, 0], 'sidewall': '#505050'},");
  EXPECT_EQ(placesOf(findUnseenTextures, with(wedge, ", 'upper': '#707070'", "")), Places{});
}

}  // namespace

}  // namespace hearth::test
