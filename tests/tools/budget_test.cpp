// That settings which fit a time do, by a clock that is not the machine's.

#include "measure/budget.h"

#include <gtest/gtest.h>

#include "loaded.h"
#include "settings/measured_pareto_front.h"
#include "support/level_text.h"

namespace hearth {
namespace {

/// Whatever is timed takes so many seconds.
Clock clockOf(double seconds) {
  return [now = 0.0, seconds]() mutable { return now += seconds; };
}

TEST(MeasuredFront, goesFromTheNearestToTruthToTheFastest) {
  const auto bakes = measuredBakes();
  for (std::size_t i = 1; i < bakes.size(); ++i) {
    EXPECT_LT(bakes[i].cost, bakes[i - 1].cost);
    EXPECT_GT(bakes[i].rms, bakes[i - 1].rms);
  }
  const auto frames = measuredFrames();
  EXPECT_EQ(frames.front().draw, DrawSettings{});
  EXPECT_EQ(frames.front().cost, 1);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_LT(frames[i].cost, frames[i - 1].cost);
    EXPECT_GT(frames[i].rms, frames[i - 1].rms);
  }
}

TEST(MeasuredFront, givesTheNearestToTruthThatIsFastEnough) {
  EXPECT_EQ(&bakeWithin(1e9), &measuredBakes().front());
  EXPECT_EQ(&bakeWithin(-1), &measuredBakes().back());
  for (const MeasuredBake& of : measuredBakes()) EXPECT_EQ(&bakeWithin(of.cost), &of);
  for (const MeasuredFrame& of : measuredFrames()) EXPECT_EQ(&frameWithin(of.cost), &of);
  EXPECT_EQ(&frameWithin(0), &measuredFrames().back());
}

TEST(Budget, ofABakeIsSpentOnTheMostAccurateSettings) {
  const LoadedLevel level = loaded("tests/levels/rooms.json");
  const BakeSettings& own = level.level.bake;
  const double coarse = measuredBakes().back().cost;
  double last = 1e9;
  for (const double factor : {0.1, 1.5, 3.0, 12.0, 100.0}) {
    // The coarse bake takes a second, the level's own 1 / coarse.
    const double budget = 1 + factor / coarse;
    const FittingBake fitting = bakeFitting(level.scene(), own, budget, 2, clockOf(1));
    EXPECT_LE(fitting.seconds, std::max(budget, 1.0)) << factor;
    EXPECT_LE(fitting.settings.texel, last) << factor;
    EXPECT_GT(fitting.rms, 0);
    last = fitting.settings.texel;
  }
  EXPECT_EQ(last, own.texel / 4);
}

TEST(Budget, isNotSpentOnMoreTexelsThanThereCanBe) {
  const LoadedLevel field =
      test::levelFrom("{'light':0.1,'sectors':{" +
                      test::sectorText("a", "0,0, 90000,0, 90000,90000, 0,90000", 0, 3) + "}}");
  BakeSettings own;
  own.texel = 2;
  ASSERT_TRUE(mistakeInSettings(field.scene(), measuredBakes().front().bake.appliedTo(own)));
  const FittingBake fitting = bakeFitting(field.scene(), own, 1e9, 2, clockOf(1));
  EXPECT_EQ(mistakeInSettings(field.scene(), fitting.settings), std::nullopt);
  EXPECT_EQ(fitting.settings.texel, own.texel) << "half of it is too fine";
}

TEST(Budget, ofAFrameIsSpentOnTheMostAccurateSettings) {
  const LoadedLevel level = loaded("tests/levels/rooms.json");
  const BakedLight light = bake(level.scene(), level.level.bake, 2);
  const Renderer renderer(level.scene(), level.textures, light);
  const Camera camera = cameraOf(level.level.shots.front());
  const auto fitting = [&](double milliseconds) {
    return frameFitting(renderer, camera, milliseconds, nullptr, clockOf(0.01));  // 10 ms a frame
  };
  EXPECT_EQ(fitting(10).draw, DrawSettings{});
  EXPECT_DOUBLE_EQ(fitting(10).milliseconds, 10);
  EXPECT_EQ(fitting(7).draw.pixelSize, 2);
  EXPECT_LE(fitting(7).milliseconds, 7);
  EXPECT_EQ(fitting(0.1).draw, measuredFrames().back().draw);
}

TEST(Budget, saysWhatItHasPickedAndWhatToExpect) {
  EXPECT_EQ(words(FittingFrame{{.pixelSize = 2}, 4.4, 0.61}),
            "--pixel-size 2: about 4.4 ms a frame, 61 % of pixels off by more than 2 levels");
  EXPECT_EQ(words(FittingFrame{{}, 10, 0.066}),
            "drawn exactly: about 10 ms a frame, 6.6 % of pixels off by more than 2 levels");
  BakeSettings settings;
  settings.texel = 0.25;
  EXPECT_EQ(words(FittingBake{settings, 1.23, 7.8}),
            "--texel 0.25 --samples 1 --soft-samples 36 --cut-off 0 --gather-error 1 --bounces 0 "
            "--no-lambert: about 1.2 s, light off by about 7.8 levels (RMS)");
}

}  // namespace
}  // namespace hearth
