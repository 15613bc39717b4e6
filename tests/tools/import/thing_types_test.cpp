#include "import/doom/thing_types.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace hearth::doom {
namespace {

using Letters = std::vector<char>;

Animation animationOf(const char* idle) {
  const ThingType type{
      .number = 1, .name = "", .sprite = "", .idle = idle, .radius = 1, .height = 1};
  return doom::animationOf(type);
}

bool isSeen(const ThingType& type) { return *type.sprite != '\0'; }

TEST(Animation, standsStillWithOneFrame) {
  const Animation animation = animationOf("A");
  EXPECT_EQ(animation.frames, (Letters{'A'}));
  EXPECT_EQ(animation.framesPerSecond, 0);
}

TEST(Animation, takesStepsOfTheTimeThatFitsAllFrames) {
  const Animation even = animationOf("A6 B6 C6");
  EXPECT_EQ(even.frames, (Letters{'A', 'B', 'C'}));
  EXPECT_EQ(even.framesPerSecond, 35.0 / 6);
  const Animation uneven = animationOf("A6 B8");
  EXPECT_EQ(uneven.frames, (Letters{'A', 'A', 'A', 'B', 'B', 'B', 'B'}));
  EXPECT_EQ(uneven.framesPerSecond, 35.0 / 2);
}

TEST(Animation, roundsDurationsThatWouldTakeTooManySteps) {
  const Animation animation = animationOf("A10 B15 C8 B6");
  EXPECT_EQ(std::string(animation.frames.begin(), animation.frames.end()), "AAABBBBBCCCBB");
  EXPECT_EQ(animation.framesPerSecond, 35.0 / 3);
  EXPECT_EQ(animationOf("A1 B100").frames.size(), 15U);
}

TEST(Animation, isBrightIfAllOfItsFramesAre) {
  EXPECT_TRUE(animationOf("A*").isBright);
  EXPECT_TRUE(animationOf("A6* B6*").isBright);
  EXPECT_FALSE(animationOf("A6 B7*").isBright);
}

TEST(ThingTypes, haveOneEntryForANumber) {
  std::set<int> numbers;
  for (const ThingType& type : thingTypes())
    EXPECT_TRUE(numbers.insert(type.number).second) << type.number;
  EXPECT_EQ(numbers.size(), 123U);
}

TEST(ThingTypes, areFoundByNumber) {
  EXPECT_STREQ(findThingType(3001)->sprite, "TROO");
  EXPECT_EQ(findThingType(65535), nullptr);
}

TEST(ThingTypes, haveASpriteOfFourLettersThatMovesInFewSteps) {
  for (const ThingType& type : thingTypes()) {
    if (!isSeen(type)) continue;
    SCOPED_TRACE(type.name);
    EXPECT_EQ(std::string(type.sprite).size(), 4U);
    const Animation animation = animationOf(type);
    EXPECT_GE(animation.frames.size(), 1U);
    EXPECT_LE(animation.frames.size(), 16U);
    EXPECT_EQ(animation.framesPerSecond > 0, animation.frames.size() > 1);
    for (const char letter : animation.frames) EXPECT_TRUE(letter >= 'A' && letter <= 'Z');
    EXPECT_GT(type.radius, 0);
    EXPECT_GT(type.height, 0);
  }
}

/// The images of a type have one size, and each is a file: no other type may want it in another.
TEST(ThingTypes, shareAllImagesOrNone) {
  std::map<std::string, std::set<char>> framesByImage;
  for (const ThingType& type : thingTypes()) {
    const Letters letters = animationOf(type).frames;
    const std::set<char> frames(letters.begin(), letters.end());
    for (const char letter : frames) {
      const auto [known, isNew] = framesByImage.emplace(std::string(type.sprite) + letter, frames);
      EXPECT_EQ(known->second, frames) << type.name;
    }
  }
}

}  // namespace
}  // namespace hearth::doom
