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

struct Limits {
  std::int64_t places = 1000;  ///< at least
  double rms = 1;              ///< levels
  double far = 0.005;          ///< of places
  std::int64_t spills = 0;
};

void compareRandomLevels(std::size_t levels, Areas areas, const Limits& limits = {}) {
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
  EXPECT_GE(sum.places, limits.places);
  EXPECT_LE(sum.rms(), limits.rms);
  EXPECT_LE(static_cast<double>(sum.far), limits.far * static_cast<double>(sum.places));
  EXPECT_LE(all.spills, limits.spills) << all.spill;
}

TEST(AreaLight, ofSkiesIsThatOfTruth) { compareRandomLevels(60, Areas::Sky); }

TEST(AreaLight, ofSurfacesThatShineIsThatOfTruth) { compareRandomLevels(30, Areas::Emitters); }

TEST(AreaLight, thatBouncesIsThatOfTruth) {
  compareRandomLevels(10, Areas::Bounces, {.places = 800, .rms = 2, .far = 0.01});
}

}  // namespace
}  // namespace hearth::area_light
