// What settings cost, by clocks that are not the machine's.

#include "measure/tradeoff/cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "../loaded.h"
#include "measure/tradeoff/measure_trials.h"

namespace hearth {
namespace {

/// Each time that it works it takes longer by the same factor.
class TiringMachine {
 public:
  double secondsFor(double work) { return work * (slowness_ *= 1.01); }

 private:
  double slowness_ = 1;
};

TEST(Cost, isWhatItIsWhileTheMachineGetsSlower) {
  TiringMachine machine;
  const TurnTimes times = timedInTurn([&] { return machine.secondsFor(1); },
                                      [&] { return machine.secondsFor(0.7); }, 20);
  ASSERT_EQ(times.trials.size(), 20U);
  EXPECT_GT(times.bases.back(), 1.4 * times.bases.front());
  EXPECT_NEAR(costOf(ratiosOf(times)), 0.7, 1e-12);
}

TEST(Cost, isWhatItIsWhereSomethingElseStrikesSingleRuns) {
  EXPECT_DOUBLE_EQ(costOf(ratiosOf({{1, 9, 1, 1, 1}, {2, 2, 40, 2}})), 2);
}

TEST(Cost, ofOneTrialLiesBetweenItsTwoRatios) {
  EXPECT_EQ(ratiosOf({{1, 4}, {4}}), (std::vector<double>{4, 1}));
  EXPECT_DOUBLE_EQ(costOf({4, 1}), 2);
}

TEST(Turns, beginAndEndWithTheBase) {
  std::string turns;
  const TurnTimes times =
      timedInTurn([&] { return turns += 'b', 1; }, [&] { return turns += 't', 0.1; }, 3);
  EXPECT_EQ(turns, "btbtbtb");
  EXPECT_EQ(times.bases, (std::vector<double>{1, 1, 1, 1}));
  EXPECT_EQ(times.trials, (std::vector<double>{0.1, 0.1, 0.1}));
}

TEST(Turns, areFewerWhereTheTrialTakesLong) {
  const auto trialsOf = [](double seconds) {
    return timedInTurn([] { return 1; }, [=] { return seconds; }, 5).trials.size();
  };
  EXPECT_EQ(trialsOf(1), 5U);
  EXPECT_EQ(trialsOf(1.5), 4U);
  EXPECT_EQ(trialsOf(2), 3U);
  EXPECT_EQ(trialsOf(100), 1U);
}

/// The base, one that is drawn otherwise, and one that is baked otherwise.
std::vector<TrialResult> measuredBy(Clock clock) {
  const LoadedLevel level = loaded("tests/levels/rooms.json");
  Trial base{"", level.level.bake, {}};
  base.bake.texel = 1;
  Trial baked = base;
  baked.bake.samples = 4;
  Trial drawn = base;
  drawn.draw.pixelSize = 2;
  TrialSetup setup;
  setup.frameSize = {24, 15};
  setup.clock = std::move(clock);
  setup.onProgress = [](std::size_t) {};
  return measureTrials(level, {base, drawn, baked},
                       truthOf(level, setup.frameSize, 1, setup.onProgress), setup);
}

TEST(Trials, costWhatTheyDoWhileTheMachineGetsSlower) {
  // Whatever is timed takes a hundredth longer than what was timed before it.
  const auto measured =
      measuredBy([now = 0.0, step = 1.0]() mutable { return now += step *= std::sqrt(1.01); });
  ASSERT_EQ(measured.size(), 3U);
  EXPECT_EQ(measured[0].bakeCost, 1);
  EXPECT_EQ(measured[0].frameCost, 1);
  EXPECT_EQ(measured[1].bakeCost, 1) << "the bake of the base";
  EXPECT_NEAR(measured[1].frameCost, 1, 1e-9);
  EXPECT_NEAR(measured[2].bakeCost, 1, 1e-9);
  EXPECT_NEAR(measured[2].frameCost, 1, 1e-9);
  EXPECT_GT(measured[0].bakeSeconds, 1);
  EXPECT_GT(measured[0].frameMilliseconds, 1000);
  for (const TrialResult& result : measured) {
    EXPECT_DOUBLE_EQ(result.bakeSeconds, result.bakeCost * measured[0].bakeSeconds);
    EXPECT_DOUBLE_EQ(result.frameMilliseconds, result.frameCost * measured[0].frameMilliseconds);
  }
}

}  // namespace
}  // namespace hearth
