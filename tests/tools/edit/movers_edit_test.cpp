// A mover's trigger and speed, as they are written into a level's file.

#include "viewer/edit/movers_edit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "desktop/disk.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

/// As it stands in the file of the tests: on a line of its own, in odd spelling.
constexpr std::string_view kGate =
    R"("gate" :{ "sectors":"hall",  "part": "ceiling", "to": 2.50, "trigger" : "use" })";

class MoversEditTest : public testing::Test {
 protected:
  MoversEditTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MoversEditTest() override { fs::remove_all(folder_); }

  /// A level with these movers in its file.
  static std::string text(std::string_view movers) {
    return "{ \"//\": \"of \\\"movers\\\": {}\",\n  \"light\": 1,\n" + std::string(movers) +
           R"(  "sectors": {
    "hall": { "floor": { "texture": "#808080" }, "ceiling": { "z": 3, "texture": "#808080" },
    "loops": { "border": { "v": [0,0, 9,0, 9,9, 0,9], "walls": { "texture": "#808080" } } } } }
}
)";
  }
  static std::string withMover(std::string_view mover) {
    return text("  \"movers\": {\r\n\t" + std::string(mover) + "\n  },\n");
  }

  LoadedLevel level(const std::string& text) {
    std::ofstream(level_, std::ios::binary) << text;
    LoadResult result = loadLevel(level_);
    for (const Diagnostic& diagnostic : result.diagnostics)
      if (!result.loaded) ADD_FAILURE() << format(diagnostic);
    return *std::move(result.loaded);
  }
  std::string file() const {
    std::ifstream stream(level_, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// The file with the mover of the level of this text edited so.
  std::string written(const std::string& text, const MoverEdit& edit) {
    const auto done = writeMover(disk_, level(text), edit);
    EXPECT_TRUE(done) << done.error();
    EXPECT_TRUE(loadLevel(level_).loaded);
    return file();
  }
  std::string refused(const LoadedLevel& loaded, const MoverEdit& edit) {
    const std::string before = file();
    const auto done = writeMover(disk_, loaded, edit);
    EXPECT_FALSE(done);
    EXPECT_EQ(file(), before);
    return done ? "" : done.error();
  }

  Disk disk_;
  fs::path folder_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path level_ = folder_ / "hall.json";
};

TEST_F(MoversEditTest, ReplacesATriggerAndNothingElse) {
  EXPECT_EQ(written(withMover(kGate), {"gate", MoverTrigger::Loop, 1.5}),
            withMover(R"("gate" :{ "sectors":"hall",  "part": "ceiling", "to": 2.50,)"
                      R"( "trigger" : "loop" })"));
}

TEST_F(MoversEditTest, AddsASpeedWhereLevelsHaveIt) {
  EXPECT_EQ(written(withMover(kGate), {"gate", MoverTrigger::Use, 0.75}),
            withMover(R"("gate" :{ "sectors":"hall",  "part": "ceiling", "to": 2.50,)"
                      R"( "speed": 0.75, "trigger" : "use" })"));
}

TEST_F(MoversEditTest, WritesBothAtOnceAndReadsThemAgain) {
  const MoverEdit edit{"gate", MoverTrigger::None, 12.125};
  written(withMover(kGate), edit);
  EXPECT_EQ(editOf(loadLevel(level_).loaded->level.movers.at(0)), edit);
}

TEST_F(MoversEditTest, AddsWhatIsMissingInAnyOrderOfTheOthers) {
  EXPECT_EQ(written(withMover(R"("gate":{"to":2.5,"//":"x","part":"ceiling","sectors":"hall"})"),
                    {"gate", MoverTrigger::Use, 2}),
            withMover(R"("gate":{"to":2.5,"//":"x","part":"ceiling","sectors":"hall",)"
                      R"("speed":2,"trigger":"use"})"));
}

TEST_F(MoversEditTest, FindsNamesThatAreSpelledWithEscapes) {
  const auto mover = [](std::string_view spelled, std::string_view speed) {
    return withMover(
        fmt::format(R"("{}": {{ "sectors": "hall", "part": "ceiling", "to": 2.5, "speed": {} }})",
                    spelled, speed));
  };
  for (const auto& [spelled, name] : {std::pair<std::string, std::string>{R"(a\"b\\)", R"(a"b\)"},
                                      {R"(\u0074\u00fcr)", "t\xC3\xBCr"},
                                      {R"(\/movers\/{}\n)", "/movers/{}\n"}})
    EXPECT_EQ(written(mover(spelled, "1"), {name, MoverTrigger::None, 0.5}), mover(spelled, "0.5"));
}

TEST_F(MoversEditTest, KeepsAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(written(mark + withMover(kGate), {"gate", MoverTrigger::Use, 2}).substr(0, 5),
            mark + "{ ");
}

TEST_F(MoversEditTest, LeavesAFileAsItIsWhereNothingDiffers) {
  EXPECT_EQ(written(withMover(kGate), {"gate", MoverTrigger::Use, 1.5}), withMover(kGate));
}

TEST_F(MoversEditTest, RefusesAMoverThatTheLevelDoesNotHave) {
  EXPECT_EQ(refused(level(text("")), {"gate", MoverTrigger::Use, 1}),
            level_.string() + ": has no mover \"gate\"");
  EXPECT_EQ(refused(level(withMover(kGate)), {"Gate", MoverTrigger::Use, 1}),
            level_.string() + ": has no mover \"Gate\"");
}

TEST_F(MoversEditTest, RefusesToWaitForFeetWithoutZones) {
  EXPECT_EQ(refused(level(withMover(kGate)), {"gate", MoverTrigger::Enter, 1}),
            level_.string() + ": the mover \"gate\" has no zones to enter");
}

TEST_F(MoversEditTest, KeepsTheZonesOfAnotherTriggerForLater) {
  const std::string gate =
      R"("gate": { "sectors": "hall", "part": "ceiling", "to": 2.5, "trigger": "enter",)"
      R"( "zones": "hall" })";
  const std::string used = written(withMover(gate), {"gate", MoverTrigger::Use, 1.5});
  EXPECT_EQ(written(used, {"gate", MoverTrigger::Enter, 1.5}), withMover(gate));
}

TEST_F(MoversEditTest, RefusesAFileThatHasChangedOrIsGone) {
  const LoadedLevel loaded = level(withMover(kGate));
  std::ofstream(level_) << "no JSON // any more";
  EXPECT_EQ(refused(loaded, {"gate", MoverTrigger::Use, 1}),
            level_.string() +
                ": has changed since it was loaded; "
                "try again once it is shown as it is");
  fs::remove(level_);
  const auto done = writeMover(disk_, loaded, {"gate", MoverTrigger::Use, 1});
  ASSERT_FALSE(done);
  EXPECT_TRUE(done.error().starts_with(level_.string() + ": ")) << done.error();
  EXPECT_FALSE(fs::exists(level_));
}

TEST_F(MoversEditTest, SaysWhenItCannotWrite) {
  class FullDisk : public Disk {
   public:
    tl::expected<void, std::string> write(const fs::path& file, std::string_view) override {
      return tl::make_unexpected(file.string() + ": cannot be written");
    }
  } full;
  const LoadedLevel loaded = level(withMover(kGate));
  const auto done = writeMover(full, loaded, {"gate", MoverTrigger::Use, 1});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error(), level_.string() + ": cannot be written");
}

}  // namespace
}  // namespace hearth
