#include "load/model/model_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace hearth {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NearestDouble, isThatOfTheCLibrary) {
  for (const char* text :
       {"0", "-0", "0.1", "1e-320", "4.9406564584124654e-324", "2.4703282292062328e-324",
        "2.2250738585072011e-308", "1.7976931348623157e308", "0.30000000000000004",
        "9007199254740993", "123456789012345678", "-3.14159265358979323846", "5e-1", "1E+2", ".5",
        "5.", "00012.500", "1.00000000000000011102230246251565404236316680908203125",
        "1.00000000000000011102230246251565404236316680908203124"}) {
    const auto number = nearestDouble(text);
    ASSERT_TRUE(number) << text;
    EXPECT_EQ(*number, std::strtod(text, nullptr)) << text;
    EXPECT_EQ(std::signbit(*number), text[0] == '-') << text;
  }
}

TEST(NearestDouble, isThatOfTheCLibraryForRandomDigits) {
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    const auto digits = 1 + random() % 25;
    const auto point = random() % digits;
    for (std::uint32_t d = 0; d < digits; ++d) {
      text += static_cast<char>('0' + random() % 10);
      if (d == point) text += '.';
    }
    text += "e" + std::to_string(static_cast<int>(random() % 700) - 350);
    EXPECT_EQ(nearestDouble(text), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(NearestDouble, isZeroBelowAllOthersAndInfiniteAboveThem) {
  const std::string zeros(400, '0');
  for (const std::string& text :
       {std::string("1e-400"), "0." + zeros + "1", "0." + zeros + "1e+3", std::string("1e-99999"),
        std::string("1e-99999999999999999999"), "1" + zeros + "e-800", std::string("9.9e-325")}) {
    EXPECT_EQ(nearestDouble(text), 0.0) << text;
    EXPECT_TRUE(std::signbit(nearestDouble("-" + text).value())) << text;
  }
  for (const std::string& text :
       {std::string("1e999"), "1" + zeros, "1" + zeros + "e-3", "0." + zeros + "1e800",
        std::string("1e99999999999999999999"), std::string("1.8e308"), std::string("inf")}) {
    EXPECT_EQ(nearestDouble(text), kInfinity) << text;
    EXPECT_EQ(nearestDouble("-" + text), -kInfinity) << text;
  }
}

TEST(NearestDouble, takesAPlus) {
  EXPECT_EQ(nearestDouble("+1.5"), 1.5);
  EXPECT_EQ(nearestDouble("+-1.5"), std::nullopt);
  EXPECT_EQ(nearestDouble("++1.5"), std::nullopt);
}

TEST(NearestDouble, isNoneOfWhatIsNoNumber) {
  for (const char* text : {"", "+", "-", ".", "e5", "1e", "1,5", "0x10", "1.2.3", "1f", "nan",
                           "NaN", "-nan", "nan(7)", "one", "1 ", " 1", "--1", "1e5.0"})
    EXPECT_EQ(nearestDouble(text), std::nullopt) << text;
}

}  // namespace
}  // namespace hearth
