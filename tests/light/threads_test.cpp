#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "light/parallel.h"
#include "support/baked_room.h"
#include "support/level_text.h"

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

const std::string kRooms =
    "{'light': 0.1, 'sectors': {" +
    test::sectorText("a", "0,0, 6,0, 6,2, 6,3, 6,5, 0,5", 0, 3,
                     "[{'texture':'#808080'},{'texture':'#808080'},{'next':'b','texture':"
                     "'#808080'},{'texture':'#808080'},{'texture':'#808080'},{'texture':"
                     "'#808080'}]") +
    "," +
    test::sectorText("b", "6,2, 9,1, 9,4, 6,3", 0.3, 2.5,
                     "[{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'},"
                     "{'next':'a','texture':'#808080'}]") +
    "}}";

std::string lightsWith(std::string_view samples) {
  return fmt::format(
      "{{'lights':[{{'x':1,'y':1,'z':2.5,'falloff':0.4,'color':'#ffc080'}},"
      "{{'x':8,'y':2.2,'z':1,'falloff':0.7,'radius':0.2}},"
      "{{'x':3.3,'y':4.1,'z':0.4,'intensity':90}}],'bake':{{'samples':{}}}}}",
      samples);
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

TEST(Bake, givesTheSameBytesForAnyNumberOfThreads) {
  for (const std::string_view samples : {"1", "4", "'auto'"}) {
    const test::BakedRoom one(kRooms, lightsWith(samples), 1);
    for (const int threads : {2, 7, 64}) {
      const test::BakedRoom many(kRooms, lightsWith(samples), threads);
      for (std::size_t i = 0; i < one.light().lightmaps.size(); ++i) {
        ASSERT_EQ(one.light().lightmaps[i].has_value(), many.light().lightmaps[i].has_value());
        if (one.light().lightmaps[i]) {
          EXPECT_EQ(one.light().lightmaps[i]->levels, many.light().lightmaps[i]->levels)
              << samples << " samples, " << threads << " threads";
        }
      }
    }
  }
}

}  // namespace
}  // namespace hearth
