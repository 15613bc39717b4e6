// The user's file of settings: which of its settings hold, what is reported, and how it is written.

#include "viewer/preferences/config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "desktop/disk.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

class ConfigTest : public testing::Test {
 protected:
  ConfigTest() { fs::remove_all(folder_); }
  ~ConfigTest() override { fs::remove_all(folder_); }

  Config read(const std::string& text) {
    write(text);
    return readConfig(disk_, file_);
  }
  void write(const std::string& text) {
    fs::create_directories(file_.parent_path());
    std::ofstream(file_) << text;
  }
  std::string written() const {
    std::ifstream stream(file_);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// What is told, without the path.
  static std::vector<std::string> told(const Config& config) {
    std::vector<std::string> lines;
    for (const Diagnostic& warning : config.warnings)
      lines.push_back(format(warning).substr(warning.file.size() + 1));
    return lines;
  }

  Disk disk_;
  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path file_ = folder_ / "hearth" / "config.json";
};

TEST_F(ConfigTest, IsAsByDefaultWithoutAFile) {
  const Config config = readConfig(disk_, file_);
  EXPECT_EQ(config.preferences, Preferences{});
  EXPECT_TRUE(config.warnings.empty());
}

TEST_F(ConfigTest, SaysHowKeysAndMouseWork) {
  const Config config = read(R"({ "//": "mine",
    "keys": { "forward": ["e", "Left Ctrl"], "fly": [] },
    "mouse": { "degreesPerPixel": 0.3, "invert": true }, "viewBob": 25 })");
  EXPECT_EQ(told(config), std::vector<std::string>{});
  EXPECT_EQ(config.preferences.keys.keysOf(Action::Forward), (std::vector{Key::E, Key::LeftCtrl}));
  EXPECT_EQ(config.preferences.keys.keysOf(Action::Crouch), (std::vector{Key::C, Key::RightCtrl}))
      << "what the user says takes a key from where it is by default";
  EXPECT_TRUE(config.preferences.keys.keysOf(Action::Fly).empty());
  EXPECT_EQ(config.preferences.degreesPerPixel, 0.3);
  EXPECT_TRUE(config.preferences.invertsPitch);
  EXPECT_EQ(config.preferences.viewBob, 0.25);
}

TEST_F(ConfigTest, TellsEachMistakeAndKeepsTheRest) {
  const Config config = read(R"({
  "mose": {},
  "keys": { "forwad": ["E"],
            "jump": ["Spcae", "J"],
            "fly": ["J"],
            "run": "R",
            "map": ["Left Alt"] },
  "mouse": { "degreesPerPixel": 0, "invert": 1 }
})");
  const std::vector<std::string> expected = {
      R"(2:3: warning: unknown key "mose", at /mose, did you mean "mouse"?)",
      R"(3:13: warning: unknown key "forwad", at /keys/forwad, did you mean "forward"?)",
      R"(4:22: warning: there is no key "Spcae", at /keys/jump/0, did you mean "Space"?)",
      R"(5:21: warning: "J" is a key of "jump" already, at /keys/fly/0, take it from one of them)",
      R"(6:20: warning: a string instead of an array of names of keys, at /keys/run, )"
      R"(give an array of names of keys)",
      R"(7:21: warning: "Left Alt" is for the desktop, at /keys/map/0, take another key)",
      R"(8:33: warning: 0 is out of range, at /mouse/degreesPerPixel, give a number from 0.01 to 10)",
      R"(8:46: warning: a number instead of true or false, at /mouse/invert, give true or false)"};
  EXPECT_EQ(told(config), expected);
  Preferences preferences;
  preferences.keys.bind(Action::Jump, {Key::J});
  EXPECT_EQ(config.preferences, preferences);
}

TEST_F(ConfigTest, IsAsByDefaultWhereTheFileIsNoJson) {
  for (const char* text : {"", "{ \"keys\": ", "[]"}) {
    const Config config = read(text);
    EXPECT_EQ(config.preferences, Preferences{}) << text;
    EXPECT_EQ(config.warnings.size(), 1) << text;
  }
}

TEST_F(ConfigTest, IsWrittenWhereItDiffersAndKeepsTheRest) {
  write("{ \"//\": \"mine\",\n  \"keys\": { \"run\": [ \"R\" ], \"jump\": [\"J\"] } }\n");
  const Preferences before = readConfig(disk_, file_).preferences;
  Preferences after = before;
  after.keys.bind(Action::Jump, {Key::Backslash, Key::K});
  after.degreesPerPixel = 0.07;
  ASSERT_TRUE(writeConfig(disk_, file_, before, after));
  EXPECT_EQ(written(),
            "{ \"//\": \"mine\",\n  \"keys\": { \"run\": [ \"R\" ], \"jump\": [\"\\\\\", \"K\"] },"
            "\n  \"mouse\": { \"degreesPerPixel\": 0.07 } }\n");
  EXPECT_EQ(readConfig(disk_, file_).preferences, after);
}

TEST_F(ConfigTest, IsMadeWithItsFolder) {
  Preferences preferences;
  preferences.invertsPitch = true;
  preferences.viewBob = 0.7;
  preferences.keys.bind(Action::Fly, {Key::W});  // which walked forward
  ASSERT_TRUE(writeConfig(disk_, file_, {}, preferences));
  const Config config = readConfig(disk_, file_);
  EXPECT_EQ(told(config), std::vector<std::string>{});
  EXPECT_EQ(config.preferences, preferences);
}

TEST_F(ConfigTest, IsNotWrittenOverWhatIsNoJson) {
  write("mine");
  Preferences preferences;
  preferences.invertsPitch = true;
  const auto result = writeConfig(disk_, file_, {}, preferences);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error(),
            file_.string() + ": is not written, as it is no JSON object; mend or remove it");
  EXPECT_EQ(written(), "mine");
}

}  // namespace
}  // namespace hearth
