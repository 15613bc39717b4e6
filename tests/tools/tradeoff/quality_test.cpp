// That the qualities are what their names say, by errors and by work, never by seconds.

#include "hearth/quality.h"

#include <gtest/gtest.h>

#include <iostream>

#include "../loaded.h"
#include "hearth/tradeoff/measure_trials.h"
#include "hearth/tradeoff/measured_front.h"

namespace hearth {
namespace {

constexpr PictureSize kSize{48, 30};

std::vector<Measured> measureAll(const LoadedLevel& level, std::vector<Trial> trials) {
  TrialBench bench;
  bench.frameSize = kSize;
  bench.threads = 2;
  bench.repeats = 1;
  bench.clock = [now = 0.0]() mutable { return ++now; };
  bench.done = [](std::size_t) {};
  return measureTrials(level, std::move(trials), truthOf(level, kSize, 2, bench.done), bench);
}

/// All qualities, measured on a shipped level: with twice its texels' side, in a quarter of the
/// time.
std::vector<Measured> measured(const std::string& path) {
  const LoadedLevel level = loaded(path);
  BakeSettings coarse = level.level.bake;
  coarse.texel *= 2;
  std::vector<Trial> trials;
  for (const Quality& quality : qualities())
    trials.push_back({std::string(quality.name), quality.bake.of(coarse), quality.draw});
  return measureAll(level, std::move(trials));
}

TEST(Qualities, fromOneToTheNextAreNearerToTruthForMoreWork) {
  for (const char* path : {"levels/tutorial.json", "levels/keep.json"}) {
    const std::vector<Measured> all = measured(path);
    for (const Measured& of : all)
      std::cout << path << ' ' << of.trial.options << ": RMS " << of.errors.light.rms << ", over 2 "
                << of.errors.picture.over2 << ", " << of.texels << " texels, " << of.rays
                << " rays, " << of.pixels << " pixels\n";
    for (std::size_t i = 1; i < all.size(); ++i) {
      const Measured& worse = all[i - 1];
      const Measured& better = all[i];
      EXPECT_LT(better.errors.light.rms, worse.errors.light.rms) << better.trial.options;
      EXPECT_LT(better.errors.picture.rms, worse.errors.picture.rms) << better.trial.options;
      EXPECT_LT(better.errors.picture.over2, worse.errors.picture.over2) << better.trial.options;
      EXPECT_GT(better.texels, worse.texels) << better.trial.options;
      EXPECT_GT(better.rays, worse.rays) << better.trial.options;
      EXPECT_GE(better.pixels, worse.pixels) << better.trial.options;
    }
  }
}

TEST(MeasuredFront, isOffByAsMuchAsItSays) {
  const LoadedLevel level = loaded("levels/tutorial.json");
  std::vector<Trial> trials;
  for (const MeasuredBake& of : measuredBakes())
    trials.push_back({"", of.bake.of(level.level.bake), {}});
  const std::vector<Measured> measured = measureAll(level, std::move(trials));
  for (std::size_t i = 0; i < measured.size(); ++i) {
    // The mean of two levels, and one of them in fewer pixels.
    const double share = measured[i].errors.light.rms / measuredBakes()[i].rms;
    EXPECT_GT(share, 0.75) << i;
    EXPECT_LT(share, 1.33) << i;
  }
}

TEST(Qualities, leaveTheLevelsOwnSettingsAsTheyAreByDefault) {
  BakeSettings own;
  own.texel = 0.3;
  own.samples = 9;
  own.lambert = true;
  const Quality* normal = qualityNamed("normal");
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->bake.of(own), own);
  EXPECT_EQ(normal->draw, DrawSettings{});
  EXPECT_EQ(qualityNamed("draft")->bake.of(own).samples, own.samples);
  EXPECT_TRUE(qualityNamed("draft")->bake.of(own).lambert);
  EXPECT_EQ(qualityNamed("best"), nullptr);
}

}  // namespace
}  // namespace hearth
