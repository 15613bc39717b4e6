#include "inputs/progress.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include "light/bakery.h"
#include "loaded.h"

namespace hearth {

namespace {

constexpr std::int64_t kHuge = std::numeric_limits<std::int64_t>::max();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::string bakingText(std::int64_t done, std::int64_t total, double seconds) {
  return progressText({Stage::Baking, done, total, seconds});
}

TEST(ProgressText, SaysFractionRateAndTimeLeft) {
  EXPECT_EQ(bakingText(420, 1000, 2), "baking    42 %  210 texels/s  3 s left");
  EXPECT_EQ(bakingText(1'500'000, 3'000'000, 90),
            "baking    50 %  16.7 k texels/s  1 min 30 s left");
  EXPECT_EQ(bakingText(1, 10, 1234), "baking    10 %  0.00081 texels/s  3 h 05 min left");
  EXPECT_EQ(bakingText(1, 101, 86400), "baking     0 %  1.16e-05 texels/s  100 days left");
}

TEST(ProgressText, SaysNothingThatCannotBeKnownYet) {
  EXPECT_EQ(bakingText(0, 1000, 5), "baking     0 %");
  EXPECT_EQ(bakingText(10, 1000, 0), "baking     1 %");
  EXPECT_EQ(progressText({Stage::Loading, 0, 0, 3}), "loading ...");
  EXPECT_EQ(progressText({Stage::Surfaces, 0, 0, 0}), "surfaces ...");
  EXPECT_EQ(progressText({Stage::Writing, 0, 0, kInfinite}), "writing ...");
}

TEST(ProgressText, IsNotDoneBeforeAllIs) {
  EXPECT_EQ(bakingText(999'999'999, 1'000'000'000, 10), "baking    99 %  100 M texels/s  1 s left");
  EXPECT_EQ(bakingText(1000, 1000, 2), "baking   100 %  500 texels/s  0 s left");
  EXPECT_EQ(percentOf({Stage::Baking, kHuge - 1, kHuge, 1}), 99);
  EXPECT_EQ(percentOf({Stage::Baking, kHuge, kHuge, 1}), 100);
}

TEST(ProgressText, FitsANarrowTerminalWhateverTheNumbers) {
  for (const std::int64_t done : {std::int64_t{0}, std::int64_t{1}, kHuge / 2, kHuge})
    for (const double seconds : {-1.0, 0.0, 1e-300, 1e-9, 1.0, 1e9, 1e300, kInfinite}) {
      const std::string text = bakingText(done, kHuge, seconds);
      EXPECT_LT(text.size(), 72U) << text;
      EXPECT_EQ(text.find("nan"), std::string::npos) << text;
      EXPECT_EQ(text.find("-1"), std::string::npos) << text;
    }
}

TEST(ProgressWriter, KeepsSilentAboutWhatIsSoonDone) {
  for (const ProgressStyle style : {ProgressStyle::Line, ProgressStyle::Lines}) {
    ProgressWriter writer(style);
    EXPECT_EQ(writer.update({Stage::Baking, 500, 1000, 0.99}), "");
    EXPECT_EQ(writer.finish(), "");
  }
}

TEST(ProgressWriter, SaysNothingWhereNothingIsWanted) {
  ProgressWriter writer(ProgressStyle::None);
  EXPECT_EQ(writer.update({Stage::Baking, 500, 1000, 100}), "");
  EXPECT_EQ(writer.finish(), "");
}

TEST(ProgressWriter, LeavesNothingOfALongerTextOnTheLine) {
  ProgressWriter writer(ProgressStyle::Line);
  EXPECT_EQ(writer.update({Stage::Surfaces, 0, 0, 1}), "\rsurfaces ...");
  // The next stage goes on with the line, however short it is.
  EXPECT_EQ(writer.update({Stage::Baking, 10, 1000, 0}), "\rbaking     1 %");
  EXPECT_EQ(writer.update({Stage::Writing, 0, 0, 0}), "\rwriting ...   ");
  EXPECT_EQ(writer.finish(), "\r           \r");
}

TEST(ProgressWriter, WritesALineForEveryTenthToAFile) {
  ProgressWriter writer(ProgressStyle::Lines);
  std::vector<std::string> lines;
  for (int i = 0; i <= 1000; ++i) {
    const std::string line = writer.update({Stage::Baking, i, 1000, i / 10.0});
    if (!line.empty()) lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 10U);
  EXPECT_EQ(lines.front(), "baking    10 %  10 texels/s  1 min 30 s left\n");
  EXPECT_EQ(lines.back(), "baking   100 %  10 texels/s  0 s left\n");
  EXPECT_EQ(writer.finish(), "");
}

TEST(ProgressWriter, WritesNoTwoLinesInASecondToAFile) {
  ProgressWriter writer(ProgressStyle::Lines);
  EXPECT_NE(writer.update({Stage::Baking, 300, 1000, 1.0}), "");
  EXPECT_EQ(writer.update({Stage::Baking, 700, 1000, 1.9}), "");
  EXPECT_NE(writer.update({Stage::Baking, 800, 1000, 2.1}), "");
}

/// A terminal whose reader can wait until it shows something.
class Terminal {
 public:
  void write(std::string_view text) {
    const std::scoped_lock lock(mutex_);
    written_ += text;
    isWritten_.notify_all();
  }
  void waitFor(std::string_view text) {
    std::unique_lock lock(mutex_);
    isWritten_.wait(lock, [&] { return written_.find(text) != std::string::npos; });
  }
  std::string written() {
    const std::scoped_lock lock(mutex_);
    return written_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable isWritten_;
  std::string written_;
};

/// The clock of these tests, in seconds.
struct TestClock {
  std::atomic<double> now = 1000;
  ProgressDisplay::Clock reader() {
    return [this] { return now.load(); };
  }
};

TEST(ProgressDisplayThread, ShowsABakeWhileItRunsAndWipesTheLineAtItsEnd) {
  const LoadedLevel rooms = loaded("tests/levels/rooms.json");
  Terminal terminal;
  TestClock clock;
  BakeProgress progress;
  {
    const ProgressDisplay display(ProgressStyle::Line, Stage::Surfaces, &progress, clock.reader(),
                                  [&](std::string_view text) { terminal.write(text); });
    clock.now = 1002;
    terminal.waitFor("surfaces ...");
    const BakedLight light = bake(rooms.scene(), {.texel = 0.5}, 4, &progress);
    terminal.waitFor("baking   100 %");
  }
  EXPECT_TRUE(terminal.written().ends_with(" \r")) << terminal.written();
  EXPECT_EQ(terminal.written().find('\n'), std::string::npos);
}

TEST(ProgressDisplayThread, TakesTheRateFromWhenTheBakeBeganAndNotItsSurfaces) {
  Terminal terminal;
  TestClock clock;
  BakeProgress progress;
  const ProgressDisplay display(ProgressStyle::Line, Stage::Surfaces, &progress, clock.reader(),
                                [&](std::string_view text) { terminal.write(text); });
  clock.now = 1100;
  terminal.waitFor("surfaces ...");
  progress.begin(1000);
  terminal.waitFor("baking     0 %");
  progress.add(250);
  clock.now = 1105;
  terminal.waitFor("baking    25 %  50 texels/s  15 s left");
}

}  // namespace

}  // namespace hearth
