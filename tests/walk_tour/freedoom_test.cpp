// Recorded walks through maps of Freedoom, imported with what moves in them: from the player's
// start through doors, over lifts and by switches to a line that ends the map.
//
// After a change of the body's rules or of what import makes, find and keep new walks with
//   HEARTH_UPDATE_WALKS=1 build/release/tests/walk_tour/test_walk_tour --gtest_filter=*Freedoom*

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "import/doom/import_map.h"
#include "import/doom/line_types.h"
#include "import/doom/map.h"
#include "import/doom/pieces.h"
#include "level/locate.h"
#include "load/load.h"
#include "support/in_tree.h"
#include "walk/moving_level.h"
#include "walk/recording.h"
#include "way_finder.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

constexpr double kUseMetres = 64 * doom::kUnit;  ///< from a switch to a player who uses it in Doom
constexpr double kBefore = 0.05;                 ///< metres from a line to where it is looked for

struct Walk {
  const char* wad;
  const char* map;
  double leap = 0;  ///< metres, see `wayThroughMovers`

  friend std::ostream& operator<<(std::ostream& out, const Walk& walk) { return out << walk.map; }
};

/// A line that ends a map.
struct Exit {
  std::array<Vec2, 2> ends;
  bool isCrossed;                 ///< else it is used from its front
  std::vector<test::Spot> spots;  ///< from which that is done

  Vec2 along() const { return ends[1] - ends[0]; }
  double before(Vec2 p) const { return cross(along(), p - ends[0]) / length(along()); }

  bool isReached(const Walker& from, const Walker& to) const {
    const Vec2 feet = to.feet.xy();
    const double fraction = dot(along(), feet - ends[0]) / dot(along(), along());
    if (fraction < 0 || fraction > 1) return false;
    if (std::ranges::find(spots, from.sector, &test::Spot::sector) == spots.end()) return false;
    return isCrossed ? (before(from.feet.xy()) > 0) != (before(feet) > 0)
                     : to.isOnGround && before(feet) > 0 && before(feet) <= kUseMetres;
  }
};

std::vector<Exit> exitsOf(const doom::Map& map, const Level& level) {
  std::vector<Exit> exits;
  for (const doom::Line& line : map.lines) {
    const doom::LineType* type = doom::findLineType(line.special);
    if (!type || type->kind != doom::LineKind::Exit) continue;
    const auto placeAt = [&](std::uint32_t vertex) {
      return doom::placeOf(map.vertices[vertex].x, map.vertices[vertex].y);
    };
    Exit exit{
        {placeAt(line.from), placeAt(line.to)}, type->activation == doom::Activation::Walk, {}};
    const Vec2 place =
        lerp(exit.ends[0], exit.ends[1], 0.5) + kBefore * unit(turned90(exit.along()));
    for (const Sector& sector : level.sectors)
      if (contains(level, sector, place)) exit.spots = test::spotsAt(level, sector.id, place);
    exits.push_back(std::move(exit));
  }
  return exits;
}

class Freedoom : public testing::TestWithParam<Walk> {
 protected:
  void SetUp() override {
    const fs::path path = fmt::format("/usr/share/games/doom/{}.wad", GetParam().wad);
    ASSERT_TRUE(fs::exists(path)) << path << " is missing: tools/setup test installs freedoom";
    const auto wad = doom::Wad::open(path, 1 << 26);
    ASSERT_TRUE(wad) << wad.error();
    const auto pictures = doom::Pictures::read(*wad);
    const auto lights = doom::parseLightTable(doom::ownLightTable());
    const fs::path folder = fs::temp_directory_path() / fmt::format("hearth-tour-{}", ::getpid());
    const auto imported =
        doom::importMap({*wad, *pictures, *lights}, GetParam().map, {.folder = folder});
    if (imported) loaded_ = loadLevel(imported->level).loaded;
    fs::remove_all(folder);
    ASSERT_TRUE(loaded_);
    exits_ = exitsOf(doom::readMap(*wad, GetParam().map).value(), level());
  }

  const Level& level() const { return loaded_->level; }
  Scene scene() const { return loaded_->scene(); }

  bool isAtExit(const Walker& before, const Walker& after) const {
    return std::ranges::any_of(exits_,
                               [&](const Exit& exit) { return exit.isReached(before, after); });
  }

  test::Aim exitAsAim() const {
    test::Aim aim;
    for (const Exit& exit : exits_)
      aim.spots.insert(aim.spots.end(), exit.spots.begin(), exit.spots.end());
    aim.isReached = [this](const Walker& before, const Walker& after) {
      return isAtExit(before, after);
    };
    return aim;
  }

  tl::expected<Recording, std::string> found() const {
    const Player& player = level().player.value();
    const RecordedStart start{level()[player.sector].name, player.eye, player.angle, 0};
    Walker walker = walkerAtStart(scene(), start).value();
    const auto way = test::wayThroughMovers(scene(), walker, GetParam().leap, exitAsAim());
    if (!way) return tl::unexpected(way.error());
    MovingLevel moving(scene());
    for (const WalkInput& input : *way) walker = moving.ticked(walker, input);
    return Recording{start, *way, recordedState(scene(), walker)};
  }

  fs::path path() const {
    return test::inTree(fmt::format("tests/walk_tour/{}-{}.txt", GetParam().wad, GetParam().map));
  }

 private:
  std::optional<LoadedLevel> loaded_;
  std::vector<Exit> exits_;
};

TEST_P(Freedoom, AWalkLeadsFromTheStartThroughWhatMovesToAnExit) {
  if (std::getenv("HEARTH_UPDATE_WALKS")) {
    const auto recording = found();
    ASSERT_TRUE(recording) << recording.error();
    std::ofstream(path()) << writeRecording(*recording);
  }
  std::ostringstream text;
  text << std::ifstream(path()).rdbuf();
  const auto recording = readRecording(text.str());
  ASSERT_TRUE(recording) << recording.error().line << ": " << recording.error().message;
  EXPECT_EQ(recording->start.eye, level().player->eye);

  MovingLevel moving(scene());
  Walker walker = walkerAtStart(scene(), recording->start).value();
  Walker before = walker;
  Walker amongStill = walker;
  for (const WalkInput& input : recording->inputs) {
    before = walker;
    walker = moving.ticked(walker, input);
    amongStill = walked(scene(), amongStill, input);
  }
  EXPECT_TRUE(isAtExit(before, walker));
  EXPECT_TRUE(recordedState(scene(), walker) == recording->end);
  EXPECT_FALSE(recordedState(scene(), amongStill) == recording->end) << "nothing had to move";
}

// A pit of 12 m lies before the exit of MAP01.
constexpr Walk kWalks[] = {
    {"freedoom1", "E1M1"},  {"freedoom1", "E1M2"},  {"freedoom1", "E1M3"},
    {"freedoom1", "E2M1"},  {"freedoom1", "E4M1"},  {"freedoom2", "MAP01", 12},
    {"freedoom2", "MAP02"}, {"freedoom2", "MAP03"}, {"freedoom2", "MAP04"},
    {"freedoom2", "MAP05"}, {"freedoom2", "MAP06"},
};

INSTANTIATE_TEST_SUITE_P(Maps, Freedoom, testing::ValuesIn(kWalks),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace hearth
