#include "measure/tradeoff/plot.h"

#include <gtest/gtest.h>

#include <regex>

namespace hearth {
namespace {

std::vector<std::pair<double, double>> circlesOf(const std::string& svg) {
  std::vector<std::pair<double, double>> circles;
  const std::regex circle("cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\"");
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), circle); it != std::sregex_iterator();
       ++it)
    circles.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  return circles;
}

TEST(Plot, putsPointsByFactorsOfCostAndEvenlyByError) {
  const auto circles =
      circlesOf(plotOf({{1, 0, false, "a"}, {10, 4, true, "b"}, {100, 8, true, "c"}}, "x", "y"));
  ASSERT_EQ(circles.size(), 3U);
  EXPECT_NEAR(circles[1].first - circles[0].first, circles[2].first - circles[1].first, 0.2);
  EXPECT_NEAR(circles[1].second - circles[0].second, circles[2].second - circles[1].second, 0.2);
  EXPECT_LT(circles[2].second, circles[0].second) << "more is higher up";
}

TEST(Plot, staysWithinItsFrameWhateverTheValues) {
  for (const double x : {0.0, 1e-9, 3e-4, 1.0, 7e5})
    for (const double y : {0.0, 1e-7, 0.3, 42.0, 1e6}) {
      const std::string svg = plotOf({{x, y, true, "a"}, {2 * x, y / 3, false, "b"}}, "x", "y");
      EXPECT_EQ(svg.find("nan"), std::string::npos) << x << ' ' << y;
      EXPECT_EQ(svg.find("inf"), std::string::npos) << x << ' ' << y;
      for (const auto& [column, line] : circlesOf(svg)) {
        EXPECT_GE(column, 0);
        EXPECT_LE(column, 640);
        EXPECT_GE(line, 0);
        EXPECT_LE(line, 400);
      }
    }
}

TEST(Plot, escapesNames) {
  const std::string svg = plotOf({{1, 1, true, "<\"&"}}, "x", "y");
  EXPECT_NE(svg.find("&lt;&quot;&amp;"), std::string::npos);
}

}  // namespace
}  // namespace hearth
