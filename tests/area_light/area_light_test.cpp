// A few of the random levels; the program beside this takes more.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "area_light/compare_areas.h"
#include "math/parallel.h"
#include "random_levels/random_level.h"

namespace hearth::area_light {
namespace {

void compareRandomLevels(std::size_t levels, Areas areas) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-area-light-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  std::vector<AreaTally> tallies(levels);
  parallelFor(levels, availableThreads(),
              [&](std::size_t i) { tallies[i] = compareRandomLevel(1 + i, areas, folder); });
  std::filesystem::remove_all(folder);
  AreaTally all;
  for (const AreaTally& tally : tallies) all += tally;
  fmt::print("{}", table(all));
  const Errors sum = all.sum();
  EXPECT_GE(sum.places, 1000);
  EXPECT_LE(sum.rms(), 1);
  EXPECT_LE(static_cast<double>(sum.far), 0.005 * static_cast<double>(sum.places));
  EXPECT_EQ(all.spills, 0) << all.spill;
}

TEST(AreaLight, ofSkiesIsThatOfTruth) { compareRandomLevels(60, Areas::Sky); }

TEST(AreaLight, ofSurfacesThatShineIsThatOfTruth) { compareRandomLevels(30, Areas::Emitters); }

}  // namespace
}  // namespace hearth::area_light
