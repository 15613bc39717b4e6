#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "math/parallel.h"

namespace hearth {
namespace {

TEST(ParallelFor, doesEveryIndexOnce) {
  for (const int threads : {1, 2, 7, 64}) {
    std::vector<std::atomic<int>> done(1000);
    parallelFor(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    for (const auto& count : done) EXPECT_EQ(count, 1) << threads << " threads";
  }
}

TEST(ParallelFor, doesNothingForNothing) {
  parallelFor(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, throwsOnWhatAnyThreadThrows) {
  for (const int threads : {1, 2, 7}) {
    const auto work = [](std::size_t i) {
      if (i == 500) throw std::bad_alloc();
    };
    EXPECT_THROW(parallelFor(1000, threads, work), std::bad_alloc) << threads << " threads";
  }
}

TEST(ParallelFor, throwsOneExceptionOfManyAndBeginsNoMoreWork) {
  std::atomic<int> begun = 0;
  const auto work = [&](std::size_t i) {
    ++begun;
    throw std::out_of_range(std::to_string(i));
  };
  EXPECT_THROW(parallelFor(1000, 7, work), std::out_of_range);
  EXPECT_LE(begun, 7);
}

TEST(Workers, doEveryIndexOfEveryPieceOnce) {
  for (const int threads : {1, 2, 7}) {
    Workers workers(threads);
    EXPECT_EQ(workers.threads(), threads);
    for (std::size_t count = 0; count < 300; ++count) {
      std::vector<std::atomic<int>> done(count);
      workers.run(count, [&](std::size_t i) { ++done[i]; });
      for (const auto& times : done) ASSERT_EQ(times, 1) << threads << " threads, " << count;
    }
  }
}

TEST(Workers, goOnAfterAnException) {
  Workers workers(3);
  EXPECT_THROW(workers.run(100, [](std::size_t) { throw std::bad_alloc(); }), std::bad_alloc);
  std::atomic<int> done = 0;
  workers.run(100, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 100);
}

TEST(Workers, endWithoutHavingWorked) { EXPECT_EQ(Workers(3).threads(), 3); }

}  // namespace
}  // namespace hearth
