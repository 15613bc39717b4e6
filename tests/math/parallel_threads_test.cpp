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

}  // namespace
}  // namespace hearth
