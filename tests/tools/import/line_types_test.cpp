#include "import/doom/line_types.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace hearth::doom {

namespace {

constexpr double kTicsPerSecond = 35;

const LineType& lineType(std::uint16_t number) {
  const LineType* type = findLineType(number);
  if (!type) ADD_FAILURE() << "there is no type " << number;
  return type ? *type : lineTypes().front();
}

/// All of Doom's types but the two that do nothing in it.
TEST(LineTypes, areThoseOfDoom) {
  std::set<int> numbers;
  for (const LineType& type : lineTypes()) EXPECT_TRUE(numbers.insert(type.number).second);
  for (int i = 1; i <= 141; ++i) EXPECT_EQ(numbers.contains(i), i != 78 && i != 85) << i;
  EXPECT_EQ(numbers.size(), 139U);
  EXPECT_EQ(findLineType(0), nullptr);
  EXPECT_EQ(findLineType(142), nullptr);
}

// As https://doomwiki.org/wiki/Linedef_type lists them.
TEST(LineTypes, haveTheSpeedsAndWaitsOfDoorsAndLifts) {
  EXPECT_EQ(lineType(1).speed, 2.1875);
  EXPECT_EQ(lineType(1).wait, 150 / kTicsPerSecond);
  EXPECT_EQ(lineType(31).wait, std::nullopt);
  EXPECT_EQ(lineType(117).speed, 8.75);
  EXPECT_EQ(lineType(118).wait, std::nullopt);
  EXPECT_EQ(lineType(16).wait, 30);
  EXPECT_EQ(lineType(62).speed, 4.375);
  EXPECT_EQ(lineType(62).wait, 105 / kTicsPerSecond);
  EXPECT_EQ(lineType(123).speed, 8.75);
  EXPECT_EQ(lineType(23).speed, 1.09375);
  EXPECT_EQ(lineType(36).speed, 4.375);
  EXPECT_EQ(lineType(20).speed, 0.546875);
  EXPECT_EQ(lineType(8).speed, 0.2734375);
}

TEST(LineTypes, startAsTheirLetterSays) {
  for (const int number : {1, 26, 27, 28, 31, 32, 33, 34, 117, 118})
    EXPECT_EQ(lineType(static_cast<std::uint16_t>(number)).activation, Activation::Push);
  for (const int number : {24, 46, 47})
    EXPECT_EQ(lineType(static_cast<std::uint16_t>(number)).activation, Activation::Shot);
  EXPECT_EQ(lineType(48).activation, Activation::Always);
  for (const int number : {2, 10, 36, 52, 88, 97, 141})
    EXPECT_EQ(lineType(static_cast<std::uint16_t>(number)).activation, Activation::Walk);
  for (const int number : {7, 11, 23, 51, 62, 103, 140})
    EXPECT_EQ(lineType(static_cast<std::uint16_t>(number)).activation, Activation::Switch);
}

TEST(LineTypes, moveOneFlatEachToADestination) {
  for (const LineType& type : lineTypes()) {
    const bool moves = type.kind <= LineKind::Stairs;
    EXPECT_EQ(moves, type.destination != Destination::None) << type.number;
    EXPECT_EQ(moves, type.speed > 0) << type.number;
    EXPECT_TRUE(!type.wait || type.kind <= LineKind::Lift) << type.number;
  }
}

TEST(LineTypes, areAsManyOfAKindAsDoomHas) {
  const auto count = [](LineKind kind) {
    return std::ranges::count(lineTypes(), kind, &LineType::kind);
  };
  EXPECT_EQ(count(LineKind::Door), 43);
  EXPECT_EQ(count(LineKind::Lift), 8);
  EXPECT_EQ(count(LineKind::Floor), 50);
  EXPECT_EQ(count(LineKind::Ceiling), 5);
  EXPECT_EQ(count(LineKind::Stairs), 4);
  EXPECT_EQ(count(LineKind::Crusher), 6);
  EXPECT_EQ(count(LineKind::Stop), 4);
  EXPECT_EQ(count(LineKind::Light), 10);
  EXPECT_EQ(count(LineKind::Teleport), 4);
  EXPECT_EQ(count(LineKind::Exit), 4);
  EXPECT_EQ(count(LineKind::Scroll), 1);
}

}  // namespace

}  // namespace hearth::doom
