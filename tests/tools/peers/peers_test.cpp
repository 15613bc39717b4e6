// How figures are held against targets; how long things take is nobody's business here.

#include "peers/peers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"
#include "peers/peer_table.h"

namespace hearth {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr Target kAtMostFour{Wanted::AtMost, 4};
constexpr Target kAtLeastFour{Wanted::AtLeast, 4};

TEST(Shortfall, isTheFractionOfTheTargetThatIsTooMuchOrMissing) {
  EXPECT_DOUBLE_EQ(shortfall(kAtMostFour, 6), 0.5);
  EXPECT_DOUBLE_EQ(shortfall(kAtLeastFour, 3), 0.25);
}

TEST(Shortfall, isNoneWhereTheTargetIsMet) {
  EXPECT_EQ(shortfall(kAtMostFour, 4), 0);
  EXPECT_EQ(shortfall(kAtMostFour, 1), 0);
  EXPECT_EQ(shortfall(kAtLeastFour, 4), 0);
  EXPECT_EQ(shortfall(kAtLeastFour, 9), 0);
}

TEST(RangeOf, isTheMedianWithTheLeastAndTheMost) {
  const Range range = rangeOf({5, 1, 4, 2, 9});
  EXPECT_EQ(range.median, 4);
  EXPECT_EQ(range.min, 1);
  EXPECT_EQ(range.max, 9);
}

/// A row that tells which of all measurements it is, and tens of that as its part.
tl::expected<Measure, std::string> prepareCount(PeerInputs& inputs) {
  return [&inputs]() -> tl::expected<Figures, std::string> {
    const double now = inputs.clock()();
    return Figures{now, 10 * now};
  };
}

tl::expected<Measure, std::string> prepareNothing(PeerInputs&) {
  return tl::unexpected<std::string>("there is no peer");
}

/// One that fails when it is measured for the second time.
tl::expected<Measure, std::string> prepareFailure(PeerInputs& inputs) {
  return [&inputs]() -> tl::expected<Figures, std::string> {
    if (inputs.clock()() > 3) return tl::unexpected<std::string>("the peer has crashed");
    return Figures{0, 0};
  };
}

PeerRow rowOf(std::string_view name, decltype(PeerRow::prepare) prepare) {
  return {name, "", "", kAtMostFour, {"tens", "hills, ms", "dales, ms"}, 1, prepare};
}

std::vector<PeerResult> measured(const std::vector<PeerRow>& rows, int repeats) {
  PeerInputs inputs("levels", [now = 0.0]() mutable { return ++now; });
  return measurePeers(rows, inputs, repeats, [](std::string_view) {});
}

TEST(MeasurePeers, measuresEverythingOnceAndThenEverythingAgain) {
  const std::vector<PeerRow> rows{rowOf("a", prepareCount), rowOf("b", prepareCount)};
  const std::vector<PeerResult> results = measured(rows, 3);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].figure.min, 1);
  EXPECT_EQ(results[0].figure.median, 3);
  EXPECT_EQ(results[0].figure.max, 5);
  EXPECT_EQ(results[1].figure.min, 2);
  EXPECT_EQ(results[1].figure.max, 6);
  ASSERT_EQ(results[1].parts.size(), 1U);
  EXPECT_EQ(results[1].parts[0].median, 40);
}

TEST(MeasurePeers, saysWhatIsMissingAndMeasuresTheRest) {
  const std::vector<PeerRow> rows{rowOf("a", prepareNothing), rowOf("b", prepareCount),
                                  rowOf("c", prepareFailure)};
  const std::vector<PeerResult> results = measured(rows, 2);
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[0].missing, "there is no peer");
  EXPECT_EQ(results[1].missing, "");
  EXPECT_EQ(results[1].figure.max, 3);
  EXPECT_EQ(results[2].missing, "the peer has crashed");
}

/// What is printed, and as JSON, of a row with such a figure.
std::string wordsOn(double figure,
                    std::string (*words)(std::span<const PeerResult>, const Machine&, int)) {
  const PeerRow row = rowOf("a", prepareCount);
  const PeerResult result{&row, "", {figure, figure, figure}, {{20, 10, 30}, {3, 3, 3}, {5, 4, 6}}};
  return words({&result, 1}, {"abacus", 1, "none"}, 1);
}

TEST(PeerTable, saysWhichMeasuredPartCostsMostWhereATargetIsMissed) {
  EXPECT_THAT(wordsOn(6, tableOf), HasSubstr("short by 50 %\n"));
  EXPECT_THAT(wordsOn(6, tableOf), HasSubstr("in the way: dales, ms: 5.00 (4.00..6.00)\n"));
  EXPECT_THAT(wordsOn(6, tableOf), HasSubstr("tens: 20.0 (10.0..30.0)\n"));
  EXPECT_THAT(wordsOn(6, jsonOf), HasSubstr(R"("inTheWay": "dales, ms")"));
}

TEST(PeerTable, saysNothingOfTheSortWhereItIsMet) {
  EXPECT_THAT(wordsOn(4, tableOf), HasSubstr("met\n"));
  EXPECT_THAT(wordsOn(4, tableOf), Not(HasSubstr("in the way")));
  EXPECT_THAT(wordsOn(4, jsonOf), Not(HasSubstr("inTheWay")));
}

TEST(PeerInputs, areGoneAfterwards) {
  std::filesystem::path folder;
  {
    const PeerInputs inputs("levels", steadySeconds);
    folder = inputs.folder();
    EXPECT_TRUE(exists(folder));
  }
  EXPECT_FALSE(exists(folder));
}

TEST(PeerRows, haveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const PeerRow& row : peerRows()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

}  // namespace
}  // namespace hearth
