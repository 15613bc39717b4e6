#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "cli/plan.h"
#include "light/light_hash.h"
#include "load/json/parse.h"
#include "load/load.h"
#include "random_levels/random_level.h"
#include "support/in_tree.h"
#include "text/json_layout.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

std::string laidOut(std::string_view json) {
  return layOut(json, std::numeric_limits<std::uint64_t>::max()).value();
}

bool isJson(const std::string& text) {
  Document document;
  document.text = text;
  Report report;
  return parse(document, 0, report) && !report.hasErrors();
}

/// The text with each character that is not in a string replaced by `outside` of it.
template <typename Replace>
std::string replacedOutsideStrings(std::string_view json, const Replace& outside) {
  std::string result;
  bool isInString = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] == '"') isInString = !isInString;
    result += isInString ? std::string(1, json[i]) : outside(json[i]);
    if (isInString && json[i] == '\\') result += json[++i];
  }
  return result;
}

bool isAnyOf(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

/// Without the blanks between keys and values: what a layout must not change.
std::string packed(std::string_view json) {
  return replacedOutsideStrings(
      json, [](char c) { return isAnyOf(c, " \t\r\n") ? std::string() : std::string(1, c); });
}

/// With a line break wherever one may be.
std::string spread(std::string_view json) {
  return replacedOutsideStrings(json, [](char c) {
    if (isAnyOf(c, "}]")) return std::string("\n\t") + c;
    return isAnyOf(c, "{[,:") ? c + std::string("\n\t") : std::string(1, c);
  });
}

std::size_t longestLine(std::string_view text) {
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  return longest;
}

/// JSON as a hostile hand would write it: any blanks, any nesting, keys of the format in any place.
class RandomJson {
 public:
  explicit RandomJson(std::uint32_t seed) : random_(seed) {}

  std::string text() { return blanks() + value(0) + blanks(); }

 private:
  std::size_t upTo(std::size_t most) { return random_() % (most + 1); }
  std::string blanks() {
    static constexpr std::array<const char*, 8> kBlanks{"",   "",     "",       " ",
                                                        "\n", "\r\n", "\n\n\n", "\t"};
    return kBlanks[upTo(kBlanks.size() - 1)];
  }
  std::string scalar() {
    static constexpr std::array<const char*, 14> kScalars{
        "0",
        "-0",
        "1.50",
        "-2.5e-300",
        "1E+3",
        "123456789012345678901234567890",
        "true",
        "false",
        "null",
        R"("")",
        R"("a b")",
        R"("\"]}\\")",
        R"("\u0000\u00e9 \ud83d\ude00")",
        "\"d\xC3\xB6rf, {a long name of a texture} [1,2]\""};
    return kScalars[upTo(kScalars.size() - 1)];
  }
  std::string key(std::size_t ordinal) {
    static constexpr std::array<const char*, 8> kKeys{"//",    "v",       "sectors", "loops",
                                                      "floor", "ceiling", "walls",   "k\\n"};
    // Comments may come twice; other keys are told apart by a number.
    const std::string key = kKeys[upTo(kKeys.size() - 1)];
    return ordinal == 0 || key == "//" ? key : key + std::to_string(ordinal);
  }
  std::string value(int depth) {
    const std::size_t kind = upTo(depth < 5 ? 5 : 1);
    if (kind <= 1) return scalar();
    const std::size_t size = upTo(upTo(9) == 0 ? 40 : 4);
    std::string text = kind == 2 ? "{" : "[";
    for (std::size_t i = 0; i < size; ++i) {
      if (i > 0) text += ",";
      text += blanks();
      if (kind == 2) text += "\"" + key(i) + "\"" + blanks() + ":" + blanks();
      text += kind == 3 ? scalar() : value(depth + 1);
      text += blanks();
    }
    return text + blanks() + (kind == 2 ? "}" : "]");
  }

  std::mt19937 random_;
};

TEST(Layout, hasALineForEachSectorAndLoopAndForMoreThanTwoObjects) {
  EXPECT_EQ(laidOut(R"({"version":1,"sectors":{"a":{"floor":{"z":0},"ceiling":{"z":3},
      "loops":{"border":{"v":[0,0,4,0,4,4],"walls":[{"next":"b"},{},{"texture":"#000000"}]},
      "pier":{"v":[1,1,2,2,2,1],"walls":{"walls":[{"z":1},{"next":"b"}]}}}}}})"),
            R"({
  "version": 1,
  "sectors": {
    "a": {
      "floor":   { "z": 0 },
      "ceiling": { "z": 3 },
      "loops": {
        "border": {
          "v": [0,0, 4,0, 4,4],
          "walls": [
            { "next": "b" },
            {},
            { "texture": "#000000" }
          ]
        },
        "pier": {
          "v": [1,1, 2,2, 2,1],
          "walls": { "walls": [ { "z": 1 }, { "next": "b" } ] }
        }
      }
    }
  }
}
)");
}

TEST(Layout, breaksWhatIsLongerThanALine) {
  EXPECT_EQ(
      laidOut(R"({"walls":[{"next":"the great hall","lower":{"name":"ashlar","scale":[1.60,1.60],
      "along":12.5,"zref":5.25},"upper":"brick"},{"//":"a lamp post beside the road to the village",
      "x":14.5,"y":41.3,"z":2.05,"color":"#ffcf90"}],"v":[10.25,10.25,20.25,10.25,30.25,10.25,40.25,
      10.25,50.25,10.25,60.25,10.25,70.25,10.25,80.25,10.25],"player":{"sector":"the great hall",
      "x":14.5,"y":41.3,"z":2.05,"angle":90,"height":1.8,"radius":0.3,"step":0.4}})"),
      R"({
  "walls": [
    { "next": "the great hall",
      "lower": { "name": "ashlar", "scale": [1.60, 1.60], "along": 12.5, "zref": 5.25 },
      "upper": "brick" },
    { "//": "a lamp post beside the road to the village",
      "x": 14.5, "y": 41.3, "z": 2.05, "color": "#ffcf90" }
  ],
  "v": [10.25,10.25, 20.25,10.25, 30.25,10.25, 40.25,10.25, 50.25,10.25, 60.25,10.25, 70.25,10.25,
        80.25,10.25],
  "player": {
    "sector": "the great hall", "x": 14.5, "y": 41.3, "z": 2.05, "angle": 90, "height": 1.8,
    "radius": 0.3, "step": 0.4
  }
}
)");
}

TEST(Layout, hasALineForEachOfMoreThanTwoThingsAndFillsThemLikeShots) {
  EXPECT_EQ(
      laidOut("{\"things\":[{\"sprite\":[\"a\",\"b\"],\"x\":1,\"y\":2},"
              "{\"frames\":[[\"a\",\"b\"],\"c\"],\"fps\":4,\"x\":1,\"y\":2,\"facing\":\"flat\"},"
              "{\"sprite\":\"barrel\",\"x\":1,\"y\":2,\"radius\":0.3,\"height\":0.9}]}"),
      R"({
  "things": [
    { "sprite": ["a", "b"], "x": 1, "y": 2 },
    { "frames": [["a", "b"], "c"], "fps": 4, "x": 1, "y": 2, "facing": "flat" },
    { "sprite": "barrel", "x": 1, "y": 2, "radius": 0.3, "height": 0.9 }
  ]
}
)");
}

TEST(Layout, keepsOneOfSeveralBlankLinesBetweenMembers) {
  EXPECT_EQ(laidOut("{\r\n\r\n\r\n\"sectors\" : {} ,\n\n\n\n\"shots\":[{}]\n\n}\n\n"),
            "{\n\n  \"sectors\": {},\n\n  \"shots\": [ {} ]\n}\n");
}

TEST(Layout, countsCharactersAndNotBytes) {
  const auto list = [](const std::string& letter) {
    std::string text;
    for (int i = 0; i < 93; ++i) text += letter;
    return "[\"" + text + "\", 1]\n";
  };
  EXPECT_EQ(laidOut(list("o")), list("o"));
  EXPECT_EQ(laidOut(list("\xC3\xB6")), list("\xC3\xB6"));
}

TEST(Layout, changesNothingButBlanksAndIsDoneAtOnce) {
  for (std::uint32_t seed = 0; seed < 5000; ++seed) {
    const std::string text = RandomJson(seed).text();
    SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << text);
    ASSERT_TRUE(isJson(text));
    const std::string result = laidOut(text);
    ASSERT_TRUE(isJson(result)) << result;
    ASSERT_EQ(packed(result), packed(text));
    ASSERT_EQ(laidOut(result), result);
  }
}

TEST(Layout, doesNotDependOnWhereTheAuthorBrokeLines) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    const std::string text = packed(RandomJson(seed).text());
    ASSERT_EQ(laidOut(spread(text)), laidOut(text)) << seed;
  }
}

TEST(Layout, ofALevelKeepsToTheLineAndMeansTheSame) {
  const fs::path folder = fs::path(testing::TempDir()) / "hearth_layout";
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomLevel level = makeRandomLevel(seed);
    const fs::path file = folder / (level.name + ".json");
    ASSERT_TRUE(writeRandomLevel(folder, level));
    const LoadResult before = loadLevel(file);
    level.levelJson = laidOut(level.levelJson);
    level.lightsJson = laidOut(level.lightsJson);
    EXPECT_LE(longestLine(level.levelJson), 100);
    EXPECT_LE(longestLine(level.lightsJson), 100);
    ASSERT_TRUE(writeRandomLevel(folder, level));
    const LoadResult after = loadLevel(file);
    ASSERT_TRUE(before.loaded && after.loaded);
    const Level& a = before.loaded->level;
    const Level& b = after.loaded->level;
    const Scene sceneA = before.loaded->scene();
    const Scene sceneB = after.loaded->scene();
    EXPECT_EQ(lightHash(sceneA, a.bake), lightHash(sceneB, b.bake));
    EXPECT_EQ(planOf(sceneA), planOf(sceneB));
    EXPECT_EQ(a.textures, b.textures);
  }
  fs::remove_all(folder);
}

TEST(Layout, isThatOfTheShippedLevels) {
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(test::inTree("levels"))) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".schema")
      continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_TRUE(laidOut(text) == text) << "hearth fmt " << entry.path();
    ++files;
  }
  EXPECT_GE(files, 4U);
}

TEST(Layout, refusesToGrowPastALimit) {
  const std::string deep = std::string(60, '[') + "{},{},{}" + std::string(60, ']');
  const std::string result = laidOut(deep);
  EXPECT_EQ(layOut(deep, result.size()), result);
  EXPECT_EQ(layOut(deep, result.size() - 1), std::nullopt);
}

}  // namespace

}  // namespace hearth
