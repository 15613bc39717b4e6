// A recorded walk through the first map of Freedoom, Phase 2, imported, to the switch that ends it.
//
// After a change of the body's rules or of what import makes, find and keep a new walk with
//   HEARTH_UPDATE_WALKS=1 build/release/tests/walk_tour/test_walk_tour --gtest_filter=Freedoom.*

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "explorer.h"
#include "import/doom/import_map.h"
#include "import/doom/map.h"
#include "import/doom/pieces.h"
#include "load/load.h"
#include "support/in_tree.h"
#include "walk/recording.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

const std::filesystem::path kRecording = test::inTree("tests/walk_tour/freedoom2-map01.txt");

/// Lines of this type end the map when they are used (https://doomwiki.org/wiki/Linedef_type), ...
constexpr std::uint16_t kExitSwitch = 11;
/// ... which a player does who stands in front of them, no more than 64 units away.
constexpr double kUseMetres = 64 * doom::kUnit;

class Freedoom : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path path = "/usr/share/games/doom/freedoom2.wad";
    ASSERT_TRUE(fs::exists(path)) << path << " is missing: tools/setup test installs freedoom";
    const auto wad = doom::Wad::open(path, 1 << 26);
    ASSERT_TRUE(wad) << wad.error();
    findExit(doom::readMap(*wad, "MAP01").value());
    const auto pictures = doom::Pictures::read(*wad);
    const auto lights = doom::parseLightTable(doom::ownLightTable());
    const fs::path folder = fs::temp_directory_path() / fmt::format("hearth-tour-{}", ::getpid());
    const auto imported = doom::importMap({*wad, *pictures, *lights}, "MAP01",
                                          {.folder = folder, .doors = doom::Doors::Open});
    if (imported) loaded_ = loadLevel(imported->level).loaded;
    fs::remove_all(folder);
    ASSERT_TRUE(loaded_);
  }

  const Level& level() const { return loaded_->level; }
  Scene scene() const { return loaded_->scene(); }

  bool isAtExit(const Walker& walker) const {
    const Vec2 along = exit_[1] - exit_[0];
    const Vec2 from = walker.feet.xy() - exit_[0];
    const double before = cross(along, from) / length(along);
    const double fraction = dot(along, from) / dot(along, along);
    return before > 0 && before <= kUseMetres && fraction >= 0 && fraction <= 1;
  }

  Recording found() const {
    const Player& player = level().player.value();
    const RecordedStart start{level()[player.sector].name, player.eye, player.angle, 0};
    Walker walker = walkerAtStart(scene(), start).value();
    const auto way = test::wayTo(scene(), walker, test::Gait::OnFoot,
                                 [this](const Walker& there) { return isAtExit(there); });
    for (const WalkInput& input : way.value()) walker = walked(scene(), walker, input);
    return {start, *way, recordedState(scene(), walker)};
  }

 private:
  void findExit(const doom::Map& map) {
    const auto line = std::ranges::find(map.lines, kExitSwitch, &doom::Line::special);
    ASSERT_NE(line, map.lines.end());
    const auto placeAt = [&](std::uint32_t vertex) {
      return doom::placeOf(map.vertices[vertex].x, map.vertices[vertex].y);
    };
    exit_[0] = placeAt(line->from);
    exit_[1] = placeAt(line->to);
  }

  std::optional<LoadedLevel> loaded_;
  Vec2 exit_[2];
};

TEST_F(Freedoom, AWalkLeadsFromTheStartToTheSwitchAtTheEnd) {
  if (std::getenv("HEARTH_UPDATE_WALKS")) std::ofstream(kRecording) << writeRecording(found());
  std::ostringstream text;
  text << std::ifstream(kRecording).rdbuf();
  const auto recording = readRecording(text.str());
  ASSERT_TRUE(recording) << recording.error().line << ": " << recording.error().message;
  EXPECT_EQ(recording->start.eye, level().player->eye);

  Walker walker = walkerAtStart(scene(), recording->start).value();
  for (const WalkInput& input : recording->inputs) walker = walked(scene(), walker, input);
  EXPECT_TRUE(isAtExit(walker));
  EXPECT_TRUE(recordedState(scene(), walker) == recording->end);
}

}  // namespace
}  // namespace hearth
