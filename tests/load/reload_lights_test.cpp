#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "load/source.h"
#include "support/temporary_folder.h"

namespace hearth {

namespace {

constexpr std::string_view kRoom = R"( "sectors": { "a": {
  "floor": {"texture": "#808080"}, "ceiling": {"texture": "#808080"},
  "loops": {"border": {"v": [0,0, 4,0, 4,4, 0,4], "walls": {"texture": "#808080"}}} } } })";
constexpr std::string_view kLamp = R"([ {"x": 1, "y": 2, "z": 1} ])";

/// A room, its lights, and what they are edited to.
class ReloadLights : public testing::Test {
 protected:
  void open(const std::string& head, std::string_view lights) {
    saveLights(lights);
    SourcedResult opened = loadLevelWithSource(folder_.write("level.json", head + kRoom.data()));
    ASSERT_TRUE(opened.result.loaded);
    loaded_ = *std::move(opened.result.loaded);
    source_ = std::move(opened.source);
  }

  void saveLights(std::string_view text) { folder_.write("level.lights.json", text); }

  std::optional<LoadResult> reload() { return reloadLights(loaded_, source_); }

  LoadResult loadAnew() const { return loadLevel(loaded_.path); }

  test::TemporaryFolder folder_;
  LoadedLevel loaded_;
  LevelSource source_;
};

TEST_F(ReloadLights, givesWhatLoadingAnewGives) {
  ASSERT_NO_FATAL_FAILURE(open("{", kLamp));
  for (const std::string_view edited :
       {R"([ {"x": 2, "y": 2, "z": 1, "falloff": 20}, {"x": 3, "y": 1, "z": 1} ])",
        R"({ "bake": {"texel": 0.5, "samples": 4}, "lights": [ {"x": 1, "y": 1, "z": 1} ] })",
        R"([ {"x": 1, "y": 0, "z": 1} ])"}) {
    saveLights(edited);
    const auto reloaded = reload();
    ASSERT_TRUE(reloaded && reloaded->loaded) << edited;
    const LoadResult anew = loadAnew();
    EXPECT_EQ(reloaded->loaded->level.lights, anew.loaded->level.lights) << edited;
    EXPECT_EQ(reloaded->loaded->level.bake, anew.loaded->level.bake) << edited;
    EXPECT_EQ(reloaded->loaded->files, anew.loaded->files);
    EXPECT_EQ(reloaded->diagnostics, anew.diagnostics) << edited;
    loaded_ = *reloaded->loaded;
  }
  EXPECT_FALSE(loadAnew().diagnostics.empty()) << "the last light lies in a wall";
}

TEST_F(ReloadLights, tellsOfMistakesWhatLoadingAnewTells) {
  ASSERT_NO_FATAL_FAILURE(open("{", kLamp));
  for (const std::string_view broken : {"[ {", R"([ {"x": 1, "y": 2, "z": 1, "colour": "red"} ])",
                                        R"([ {"x": 9, "y": 2, "z": 1}, {"x": 1, "y": 2} ])",
                                        R"([ {"x": 1, "y": 2, "z": 1, "sector": "b"} ])"}) {
    saveLights(broken);
    const auto reloaded = reload();
    ASSERT_TRUE(reloaded) << broken;
    const LoadResult anew = loadAnew();
    EXPECT_EQ(reloaded->loaded.has_value(), anew.loaded.has_value()) << broken;
    EXPECT_EQ(reloaded->diagnostics, anew.diagnostics) << broken;
  }
}

TEST_F(ReloadLights, keepsTheSourceOfTheLevelThatItReturns) {
  ASSERT_NO_FATAL_FAILURE(open("{", kLamp));
  const auto textOfFirstLight = [this] {
    const Place place = source_.lights.lights.at(0).place;
    return source_.documents[place.document].text.substr(place.offset);
  };
  saveLights(R"([ {"x": 7, "y": 2, "z": 1} ])");
  ASSERT_FALSE(reload()->loaded);
  EXPECT_TRUE(textOfFirstLight().starts_with(R"({"x": 1)"));
  saveLights(R"([ {"x": 3, "y": 2, "z": 1} ])");
  ASSERT_TRUE(reload()->loaded);
  EXPECT_TRUE(textOfFirstLight().starts_with(R"({"x": 3)"));
}

TEST_F(ReloadLights, leavesALevelWithoutALightsFileToTheLoader) {
  ASSERT_NO_FATAL_FAILURE(open("{", kLamp));
  std::filesystem::remove(folder_.path() / "level.lights.json");
  EXPECT_FALSE(reload());
}

TEST_F(ReloadLights, leavesALevelThatIsBrightWithoutLightsToTheLoader) {
  ASSERT_NO_FATAL_FAILURE(open("{", kLamp));
  saveLights("[]");
  EXPECT_FALSE(reload()) << "its last light is gone";
  ASSERT_NO_FATAL_FAILURE(open("{", "[]"));
  saveLights(kLamp);
  EXPECT_FALSE(reload()) << "its first light is there";
  ASSERT_NO_FATAL_FAILURE(open(R"({ "light": 0.2, )", kLamp));
  saveLights("[]");
  EXPECT_TRUE(reload()) << "it says how bright it is";
}

}  // namespace

}  // namespace hearth
