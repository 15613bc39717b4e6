#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "load_text.h"

/// Large levels load in seconds. The bounds are a multiple of what they take on a machine of two
/// slow cores: they tell n log n from n squared, no more.
namespace hearth {
namespace {

constexpr double kSeconds = 60;

/// Of processor time, which does not pass while other programs run.
class Stopwatch {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

std::string wallTo(int x, int y, int side) {
  if (x < 0 || y < 0 || x >= side || y >= side) return "{'texture': '#808080'}";
  return fmt::format("{{'next': 'r{}_{}'}}", x, y);
}

std::string grid(int side) {
  std::string text;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (!text.empty()) text += ",";
      text +=
          sectorText(fmt::format("r{}_{}", x, y),
                     fmt::format("{0},{1}, {2},{1}, {2},{3}, {0},{3}", x, y, x + 1, y + 1),
                     fmt::format("[{}, {}, {}, {}]", wallTo(x, y - 1, side), wallTo(x + 1, y, side),
                                 wallTo(x, y + 1, side), wallTo(x - 1, y, side)));
    }
  return text;
}

TEST(Size, aHundredThousandSectors) {
  const std::string text = "{'light': 1, 'sectors': {" + grid(317) + "}}";
  const Stopwatch watch;
  const LoadResult result = loadText(text);
  EXPECT_LT(watch.seconds(), kSeconds);
  ASSERT_TRUE(result.loaded);
  EXPECT_EQ(result.loaded->level.sectors.size(), 317U * 317U);
  expectTwins(result.loaded->scene());
}

/// Vertices of a circle; with `step` -1 the other way round.
std::string circle(int vertices, int radius, int step) {
  std::string text;
  for (int i = 0; i < vertices; ++i) {
    const double angle = step * 2 * 3.14159265358979 * i / vertices;
    if (i > 0) text += ",";
    text += fmt::format("{},{}", radius * std::cos(angle), radius * std::sin(angle));
  }
  return text;
}

TEST(Size, sectorsOfTenThousandVerticesThatShareAllTheirWalls) {
  const std::string text =
      "{'light': 1, 'sectors': {'ring': {'floor': {'texture': '#808080'}, 'ceiling': {'texture': "
      "'#404040'}, 'loops': {'border': {'v': [" +
      circle(10'000, 200, 1) + "], 'walls': {'texture': '#808080'}}, 'hole': {'v': [" +
      circle(10'000, 100, -1) + "], 'walls': {'next': 'disc'}}}}," +
      sectorText("disc", circle(10'000, 100, 1), "{'next': 'ring'}") + "}}";
  const Stopwatch watch;
  const LoadResult result = loadText(text);
  EXPECT_LT(watch.seconds(), kSeconds);
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.loaded->level.segments.size(), 30'000U);
}

TEST(Size, aWallThatTenThousandOthersSplit) {
  std::string vertices = "0,-5, 10000,-5";
  std::string walls = "{'texture': '#808080'}, {'texture': '#808080'}";
  for (int x = 10'000; x >= 0; --x) {
    vertices += fmt::format(", {},0", x);
    walls += x > 0 ? ", {'next': 'hall'}" : ", {'texture': '#808080'}";
  }
  const std::string text =
      "{'light': 1, 'sectors': {" +
      sectorText("hall", "0,0, 10000,0, 10000,10, 0,10",
                 "[{'next': 'comb'}, {'texture': '#808080'}, {'texture': '#808080'}, {'texture': "
                 "'#808080'}]") +
      "," + sectorText("comb", vertices, "[" + walls + "]") + "}}";
  const Stopwatch watch;
  const LoadResult result = loadText(text);
  EXPECT_LT(watch.seconds(), kSeconds);
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.loaded->level.segments.size(), 10'003U + 10'003U);
}

TEST(Size, sixtyFourMegabytesOfSpaces) {
  const Stopwatch watch;
  EXPECT_FALSE(loadText(std::string(std::size_t{64} << 20, ' ')).loaded);
  EXPECT_LT(watch.seconds(), kSeconds);
}

TEST(Size, thirtyMillionZeros) {
  std::string zeros = "[0";
  while (zeros.size() + 3 < std::size_t{60} << 20) zeros += ",0";
  const Stopwatch watch;
  EXPECT_FALSE(loadText(zeros + "]").loaded);
  EXPECT_LT(watch.seconds(), kSeconds);
}

TEST(Size, fifteenMillionViewsOfASprite) {
  std::string views = "{'light': 1, 'things': [{'x': 1, 'y': 1, 'sprite': ['a'";
  while (views.size() + 4 < std::size_t{60} << 20) views += ",'a'";
  const Stopwatch watch;
  const LoadResult result =
      loadText(views + "]}], 'sectors': {" + sectorText("a", "0,0, 4,0, 4,4, 0,4") + "}}");
  EXPECT_LT(watch.seconds(), kSeconds);
  EXPECT_EQ(countErrors(result), 1U) << listed(result);
}

TEST(Size, aQuarterOfAMillionSprites) {
  std::string things;
  for (int i = 0; i < 250'000; ++i)
    things += fmt::format("{}{{'x':{},'y':{},'sprite':'#c04020'}}", i > 0 ? "," : "", 0.5 + i % 317,
                          0.5 + i / 317 % 317);
  const Stopwatch watch;
  const LoadResult result =
      loadText("{'light': 1, 'things': [" + things + "], 'sectors': {" + grid(317) + "}}");
  EXPECT_LT(watch.seconds(), kSeconds);
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.loaded->level.sprites.size(), 250'000U);
}

TEST(Size, aThousandBodiesThatReachEverywhere) {
  std::string things;
  for (int i = 0; i < 1000; ++i)
    things += fmt::format("{}{{'x':{},'y':0.5,'sprite':'#c04020','radius':1e9,'height':1}}",
                          i > 0 ? "," : "", 0.5 + i % 33);
  const Stopwatch watch;
  const LoadResult result =
      loadText("{'light': 1, 'things': [" + things + "], 'sectors': {" + grid(33) + "}}");
  EXPECT_LT(watch.seconds(), kSeconds);
  ASSERT_EQ(countErrors(result), 1U) << listed(result);
  EXPECT_EQ(result.diagnostics[0].pointer, "/things/918") << "1089 sectors each";
}

}  // namespace
}  // namespace hearth
