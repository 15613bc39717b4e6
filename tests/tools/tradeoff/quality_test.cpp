// That the qualities are what their names say, by errors and by work, never by seconds.

#include "settings/quality.h"

#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "../loaded.h"
#include "measure/tradeoff/measure_trials.h"
#include "settings/measured_pareto_front.h"
#include "settings/measured_settings.h"

namespace hearth {
namespace {

constexpr ImageSize kSize{48, 30};

std::vector<TrialResult> measureAll(const LoadedLevel& level, std::vector<Trial> trials) {
  TrialSetup setup;
  setup.frameSize = kSize;
  setup.threads = 2;
  setup.repeats = 1;
  setup.clock = [now = 0.0]() mutable { return ++now; };
  setup.onProgress = [](std::size_t) {};
  return measureTrials(level, std::move(trials), truthOf(level, kSize, 2, setup.onProgress), setup);
}

/// All qualities, measured on a shipped level: with twice its texels' side, in a quarter of the
/// time.
std::vector<TrialResult> measured(const std::string& path) {
  const LoadedLevel level = loaded(path);
  BakeSettings coarse = level.level.bake;
  coarse.texel *= 2;
  std::vector<Trial> trials;
  for (const Quality& quality : qualities())
    trials.push_back({std::string(quality.name), quality.bake.appliedTo(coarse), quality.draw});
  return measureAll(level, std::move(trials));
}

TEST(Qualities, fromOneToTheNextAreNearerToTruthForMoreWork) {
  for (const char* path : {"levels/tutorial.json", "levels/keep.json"}) {
    const std::vector<TrialResult> all = measured(path);
    for (const TrialResult& of : all)
      std::cout << path << ' ' << of.trial.options << ": RMS " << of.errors.light.rms << ", over 2 "
                << of.errors.picture.over2 << ", " << of.texels << " texels, " << of.rays
                << " rays, " << of.pixels << " pixels\n";
    for (std::size_t i = 1; i < all.size(); ++i) {
      const TrialResult& worse = all[i - 1];
      const TrialResult& better = all[i];
      EXPECT_LT(better.errors.light.rms, worse.errors.light.rms) << better.trial.options;
      EXPECT_LT(better.errors.picture.rms, worse.errors.picture.rms) << better.trial.options;
      EXPECT_LT(better.errors.picture.over2, worse.errors.picture.over2) << better.trial.options;
      EXPECT_GT(better.texels, worse.texels) << better.trial.options;
      EXPECT_GT(better.rays, worse.rays) << better.trial.options;
      EXPECT_GE(better.pixels, worse.pixels) << better.trial.options;
    }
  }
}

/// What was said is the mean of two levels, this one of them, and in more pixels.
void expectOffBy(const std::vector<double>& said, const std::vector<TrialResult>& measured) {
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double fraction = measured[i].errors.light.rms / said[i];
    EXPECT_GT(fraction, 0.75) << i << ": " << measured[i].trial.options;
    EXPECT_LT(fraction, 1.33) << i << ": " << measured[i].trial.options;
  }
}

TEST(MeasuredFront, isOffByAsMuchAsItSays) {
  const LoadedLevel level = loaded("levels/tutorial.json");
  std::vector<Trial> trials;
  std::vector<double> said;
  const auto add = [&](const MeasuredBake& of) {
    trials.push_back({"", of.bake.appliedTo(level.level.bake), {}});
    said.push_back(of.rms);
  };
  add(measuredBakes().back());  // first, as it is baked again beside all others: the fastest
  for (const MeasuredBake& of : measuredBakes()) add(of);
  expectOffBy(said, measureAll(level, std::move(trials)));
}

TEST(MeasuredSettings, ofBakesAreOffByAsMuchAsTheySay) {
  const LoadedLevel level = loaded("levels/tutorial.json");
  std::vector<Trial> trials;
  std::vector<double> said;
  for (const MeasuredSetting& of : measuredSettings()) {
    OptionValues values;
    values.set(of.setting, std::string(of.value));
    const auto bake = bakeSettingsFor(level.scene(), values).value();
    // What takes long is left out. This level has neither masked middle textures nor light of
    // areas.
    if (bake == level.level.bake || of.cost > 4 || of.setting == Option::MiddleShadows ||
        of.setting == Option::GatherError)
      continue;
    trials.push_back({std::string(of.value), bake, {}});
    said.push_back(of.off);
  }
  expectOffBy(said, measureAll(level, std::move(trials)));
}

TEST(Qualities, leaveTheLevelsOwnSettingsAsTheyAreByDefault) {
  BakeSettings own;
  own.texel = 0.3;
  own.samples = 9;
  own.lambert = true;
  const Quality* normal = qualityNamed("normal");
  ASSERT_TRUE(normal);
  EXPECT_EQ(normal->bake.appliedTo(own), own);
  EXPECT_EQ(normal->draw, DrawSettings{});
  EXPECT_EQ(qualityNamed("draft")->bake.appliedTo(own).samples, own.samples);
  EXPECT_TRUE(qualityNamed("draft")->bake.appliedTo(own).lambert);
  EXPECT_EQ(qualityNamed("best"), nullptr);
}

}  // namespace
}  // namespace hearth
