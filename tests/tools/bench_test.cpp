// What `hearth bench` counts; how long it takes is nobody's business here.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "loaded.h"
#include "measure/level_bench.h"

namespace hearth {
namespace {

TEST(Spread, isOfTheValuesThatHalfAndNineteenOfTwentyDoNotExceed) {
  std::vector<double> values(100);
  std::iota(values.rbegin(), values.rend(), 1.0);  // 100, 99 ... 1
  EXPECT_EQ(spreadOf(values).median, 50);
  EXPECT_EQ(spreadOf(values).p95, 95);
  EXPECT_EQ(spreadOf({7}).median, 7);
  EXPECT_EQ(spreadOf({7}).p95, 7);
}

/// A clock that goes on by a second whenever it is read: whatever is timed takes one.
Clock countingClock() {
  return [now = 0.0]() mutable { return now++; };
}

double mean(const FrameBench& frame, std::string_view counter) {
  const auto found = std::ranges::find(frame.counters, counter, &FrameCounter::name);
  return found == frame.counters.end() ? std::nan("") : found->mean;
}

TEST(Measure, timesEverySizeAndTheBakeOnOneThreadAndOnAll) {
  const LoadedLevel level = loaded("tests/levels/rooms.json");
  const BenchReport report = measure(level, level.level.bake, {}, 3, 2, countingClock());
  ASSERT_EQ(report.frames.size(), 6U);
  ASSERT_EQ(report.bakes.size(), 2U);
  EXPECT_EQ(report.frames.front().threads, 1);
  EXPECT_EQ(report.frames.back().threads, 3);
  EXPECT_EQ(report.frames.back().size, (ImageSize{1920, 1080}));
  for (const FrameBench& frame : report.frames) {
    EXPECT_EQ(frame.milliseconds.median, 2000);
    EXPECT_EQ(frame.findMilliseconds.median, 1000);
    EXPECT_EQ(frame.colorMilliseconds.median, 1000);
    EXPECT_EQ(frame.writeMilliseconds.median, 1000);
    EXPECT_GE(mean(frame, "spans"), frame.size.width) << "at least one to a column";
    EXPECT_GE(mean(frame, "viewports"), 1);
    for (const FrameCounter& counter : frame.counters) EXPECT_NE(counter.name, "");
  }
  for (const BakeBench& bake : report.bakes) EXPECT_EQ(bake.seconds.p95, 1);
}

TEST(Measure, countsTestsAsTheBakeDoes) {
  const LoadedLevel level = loaded("tests/levels/rooms.json");
  const BenchReport report = measure(level, level.level.bake, {}, 1, 1, countingClock());
  ASSERT_EQ(report.frames.size(), 3U) << "one thread is all that there are";
  EXPECT_GT(report.texelLightTests, report.bake.texels);
  EXPECT_LT(report.bake.rays, report.texelLightTests) << "answered with fewer rays";
}

}  // namespace
}  // namespace hearth
