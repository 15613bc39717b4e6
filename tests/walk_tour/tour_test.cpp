// Recorded walks through the tutorial level: where they lead, and that they end there in every
// build, to the bit.
//
// After a change of the body's rules or of the level's geometry, find and keep new walks with
//   HEARTH_UPDATE_WALKS=1 build/release/tests/walk_tour/test_walk_tour

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "explorer.h"
#include "load/load.h"
#include "support/in_tree.h"
#include "walk/recording.h"

namespace hearth {
namespace {

class Tour : public testing::Test {
 protected:
  Walker startOfPlayer() const { return walkerAtStart(scene_, start_).value(); }

  /// Finds a walk and keeps it where that is asked for; reads the one that is kept.
  Recording recording(const std::string& name, test::Gait gait) const {
    const std::filesystem::path path = test::inTree("tests/walk_tour/" + name);
    if (std::getenv("HEARTH_UPDATE_WALKS")) {
      Walker walker = startOfPlayer();
      const std::vector<WalkInput> inputs =
          test::exploration(scene_, walker, gait, {sectorNamed("chasm"), sectorNamed("abyss")});
      for (const WalkInput& input : inputs) walker = walked(scene_, walker, input);
      std::ofstream(path) << writeRecording({start_, inputs, recordedState(scene_, walker)});
    }
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    const auto read = readRecording(text.str());
    if (!read) ADD_FAILURE() << path << ':' << read.error().line << ": " << read.error().message;
    return read.value();
  }

  SectorId sectorNamed(const std::string& name) const {
    return SectorId(static_cast<std::size_t>(
        std::ranges::find(level_.sectors, name, &Sector::name) - level_.sectors.begin()));
  }

  std::set<std::string> unvisited(const Recording& recording) const {
    const std::vector<bool> isVisited = test::visitedSectors(
        scene_, walkerAtStart(scene_, recording.start).value(), recording.inputs);
    std::set<std::string> names;
    for (std::size_t i = 0; i < level_.sectors.size(); ++i)
      if (!isVisited[i]) names.insert(level_.sectors[i].name);
    return names;
  }

  RecordedState endOf(const Recording& recording) const {
    Walker walker = walkerAtStart(scene_, recording.start).value();
    for (const WalkInput& input : recording.inputs) walker = walked(scene_, walker, input);
    return recordedState(scene_, walker);
  }

  LoadedLevel loaded_ = loadLevel(test::inTree("levels/tutorial.json")).loaded.value();
  const Level& level_ = loaded_.level;
  const Scene scene_ = loaded_.scene();
  RecordedStart start_{level_[level_.player->sector].name, level_.player->eye, level_.player->angle,
                       0};
};

// Nobody can be in the closed door: its ceiling is its floor.

TEST_F(Tour, FlyingLeadsThroughEverySectorThatHasAir) {
  const Recording tour = recording("tutorial-flying.txt", test::Gait::Flying);
  EXPECT_EQ(unvisited(tour), std::set<std::string>{"door"});
  EXPECT_TRUE(endOf(tour) == tour.end);
}

TEST_F(Tour, OnFootLeadsThroughAllButWhatOnlyFlyersReach) {
  const Recording tour = recording("tutorial-on-foot.txt", test::Gait::OnFoot);
  EXPECT_EQ(unvisited(tour),
            (std::set<std::string>{"attic-north", "door", "gallery", "lantern", "shed-roof"}));
  EXPECT_TRUE(endOf(tour) == tour.end);
}

}  // namespace
}  // namespace hearth
