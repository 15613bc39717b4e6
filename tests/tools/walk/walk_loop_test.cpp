// The walk as a program, in lockstep with a clock and events that the test gives it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "image/image_file.h"
#include "staged_walk.h"

namespace hearth {
namespace {

using test::click;
using test::down;
using test::motion;
using Walk = test::StagedWalk;

Walker walkedFor(const Scene& scene, Walker walker, const WalkInput& input, int ticks) {
  for (int i = 0; i < ticks; ++i) walker = walked(scene, walker, input);
  return walker;
}

// --- Time ----------------------------------------------------------------------------------------

TEST(WalkTime, AKeyWalksByTicksWhateverTheFramesTake) {
  const auto expectTicks = [](double ticks, int rounds, double seconds) {
    Walk walk;
    walk.now(down(Key::Left));
    walk.now(down(Key::W));
    walk.go(rounds, seconds);
    const auto passed = static_cast<int>(walk.inputs().size());
    EXPECT_NEAR(passed, ticks, 1) << seconds;  // times that are not exact round down
    EXPECT_EQ(walk.walker(),
              walkedFor(walk.scene(), walk.start(), {.forward = 127, .turn = -2000}, passed))
        << seconds;
  };
  expectTicks(48, 48, 1.0 / 64);
  expectTicks(48, 768, 1.0 / 1024);
  expectTicks(48, 5, 0.15);
  expectTicks(48, 3, 0.25);
  expectTicks(48, 3, 10);  // which makes up for a quarter of a second
}

TEST(WalkTime, NoTimeAndTimeSetBackAreNoTicks) {
  Walk walk;
  walk.now(down(Key::W));
  walk.go(100, 0);
  EXPECT_TRUE(walk.inputs().empty());
  walk.ticks(4);
  walk.go(1, -500);
  EXPECT_EQ(walk.inputs().size(), 4);
  walk.ticks(4);
  EXPECT_EQ(walk.inputs().size(), 8);
}

TEST(WalkTime, TheViewLiesBetweenTheLastTwoTicks) {
  Walk walk;
  walk.now(down(Key::W));
  walk.ticks(8);
  const Image before = walk.stage.shown;
  EXPECT_EQ(before, walk.drawn(LightMode::Both, {64, 40}));
  walk.go(1, 0.5 / kTicksPerSecond);
  EXPECT_EQ(walk.inputs().size(), 8);
  EXPECT_NE(walk.stage.shown, before);
}

TEST(WalkTime, NothingIsDrawnWhileNothingChanges) {
  Walk walk;
  walk.ticks(2);
  const int frames = walk.stage.frames;
  const int rests = walk.stage.rests;
  walk.ticks(100);
  EXPECT_EQ(walk.stage.frames, frames);
  EXPECT_EQ(walk.stage.rests, rests + 100);
  walk.now(WindowEvent::Changed);
  EXPECT_EQ(walk.stage.frames, frames + 1);
}

TEST(WalkTime, FramesKeepToTheirCap) {
  Walk walk({.frameCap = 32});
  walk.now(down(Key::Right));
  walk.ticks(2);
  const int frames = walk.stage.frames;
  walk.go(256, 1.0 / 256);
  EXPECT_EQ(walk.stage.frames, frames + 32);
  EXPECT_EQ(walk.inputs().size(), 66);
  walk.go(1, -500);
  walk.go(1, 1.0 / 32);
  EXPECT_EQ(walk.stage.frames, frames + 33) << "a clock that was set back stops no frames";
}

TEST(WalkTime, TheTitleTellsTheRateOnceASecond) {
  Walk walk;
  EXPECT_EQ(walk.stage.title, "rooms");
  walk.now(down(Key::Right));
  walk.ticks(2 * 64);
  EXPECT_EQ(walk.stage.title, "rooms - 0.0 ms, 64 frames/s");
}

// --- Input ---------------------------------------------------------------------------------------

TEST(WalkInputs, TheMouseIsCapturedByAClickAndFreedByEsc) {
  Walk walk;
  walk.now(motion(100, 0));
  walk.ticks(1);
  EXPECT_EQ(walk.walker().angle, walk.start().angle);
  walk.now(click());
  EXPECT_TRUE(walk.stage.isMouseCaptured);
  walk.now(motion(100, 0));
  walk.ticks(1);
  EXPECT_NEAR(walk.walker().angle - walk.start().angle, 15, 1e-9);
  walk.now(down(Key::Escape));
  EXPECT_FALSE(walk.stage.isMouseCaptured);
  EXPECT_TRUE(walk.isOn);
  walk.now(down(Key::Escape));
  EXPECT_FALSE(walk.isOn);
}

TEST(WalkInputs, ClosingTheWindowLeavesAtOnce) {
  Walk walk;
  walk.now(click());
  walk.now(WindowEvent::CloseAsked);
  EXPECT_FALSE(walk.isOn);
}

TEST(WalkInputs, WhoLosesTheFocusLetsGoOfKeysAndMouse) {
  Walk walk;
  walk.now(click());
  walk.now(down(Key::W));
  walk.now(WindowEvent::FocusLost);
  EXPECT_FALSE(walk.stage.isMouseCaptured);
  walk.ticks(2);
  EXPECT_EQ(walk.inputs().back(), WalkInput{});
}

TEST(WalkInputs, FlightIsToggledInOneTick) {
  Walk walk;
  walk.now(down(Key::N));
  walk.go(1, 0.25);
  ASSERT_EQ(walk.inputs().size(), 16);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(walk.inputs()[i].toggleFlight, i == 0);
}

TEST(WalkInputs, ARecordedWalkIsReplayedToTheBitAtAnyFrameRate) {
  Walk walk;
  walk.now(click());
  for (const Key code : {Key::W, Key::LeftShift, Key::Space}) {
    walk.now(down(code));
    walk.now(motion(37, -11));
    walk.go(7, 0.043);
  }
  const std::vector<WalkInput> inputs = walk.inputs();
  for (const double seconds : {0.001, 0.1, 10.0}) {
    Walk again;
    again.loop().replay(inputs);
    again.now(down(Key::S));  // whatever the user does
    again.go(5000, seconds);
    EXPECT_FALSE(again.isOn);
    EXPECT_TRUE(again.loop().isReplayOver());
    EXPECT_EQ(again.walker(), walk.walker());
  }
}

TEST(WalkInputs, ARecordedWalkIsReplayedWhateverTheUsersSettings) {
  Preferences preferences;
  preferences.keys.bind(Action::Forward, {Key::E});
  preferences.degreesPerPixel = 0.02;
  preferences.viewBob = 1;
  Walk walk({.preferences = preferences});
  walk.now(click());
  walk.now(down(Key::E));
  walk.now(motion(100, 20));
  walk.ticks(40);
  EXPECT_NEAR(walk.walker().angle - walk.start().angle, 2, 1e-9);
  const std::vector<WalkInput> inputs = walk.inputs();
  Walk again;
  again.loop().replay(inputs);
  again.ticks(100);
  EXPECT_EQ(again.walker(), walk.walker());
}

// --- Pictures ------------------------------------------------------------------------------------

TEST(WalkPictures, AreWhatShotDraws) {
  Walk walk;
  for (const auto& [code, mode] :
       {std::pair{Key::Digit2, LightMode::None}, std::pair{Key::Digit3, LightMode::Only},
        std::pair{Key::Digit1, LightMode::Both}}) {
    walk.now(down(code));
    EXPECT_EQ(walk.stage.shown, walk.drawn(mode, {64, 40}));
  }
}

TEST(WalkPictures, FollowTheWindow) {
  Walk walk;
  for (const ImageSize size : {ImageSize{1, 1}, {160, 100}, {30, 90}, {640, 1}, {1, 64}}) {
    walk.stage.window = size;
    walk.now(WindowEvent::Changed);
    EXPECT_EQ(walk.stage.shown, walk.drawn(LightMode::Both, size));
  }
}

TEST(WalkPictures, GoUpAndDownWithTheStepsWhereTheUserLikesThat) {
  Walk still;
  Walk bobbing({.preferences = {.viewBob = 1}});
  EXPECT_EQ(bobbing.stage.shown, still.stage.shown);
  for (Walk* walk : {&still, &bobbing}) {
    walk->now(down(Key::W));
    walk->ticks(12);
  }
  EXPECT_EQ(bobbing.walker(), still.walker()) << "it moves what is seen only";
  EXPECT_EQ(still.stage.shown, still.drawn(LightMode::Both, {64, 40}));
  EXPECT_NE(bobbing.stage.shown, still.stage.shown);
}

TEST(WalkPictures, HaveTheSizeAndTheFieldOfViewThatWereAskedFor) {
  Walk walk({.size = ImageSize{32, 20}, .fov = 60});
  walk.stage.window = ImageSize{500, 100};
  walk.now();
  EXPECT_EQ(walk.stage.shown, walk.drawn(LightMode::Both, {32, 20}));
}

TEST(WalkPictures, AreNotDrawnForAWindowThatCannotBeSeen) {
  Walk walk;
  walk.stage.window.reset();
  walk.now(down(Key::Right));
  const int frames = walk.stage.frames;
  walk.ticks(10);
  EXPECT_EQ(walk.stage.frames, frames);
  EXPECT_EQ(walk.inputs().size(), 10) << "the walk goes on";
}

TEST(WalkPictures, MapAndKeysComeAndGo) {
  Walk walk;
  walk.stage.window = ImageSize{320, 200};
  walk.now();
  const Image plain = walk.stage.shown;
  for (const Key code : {Key::Tab, Key::H}) {
    walk.now(down(code));
    EXPECT_NE(walk.stage.shown, plain);
    walk.now(down(code));
    EXPECT_EQ(walk.stage.shown, plain);
  }
  walk.now(down(Key::Tab));
  const Image map = walk.stage.shown;
  walk.now(down(Key::Equals));
  EXPECT_NE(walk.stage.shown, map);
  walk.now(down(Key::F11));
  EXPECT_TRUE(walk.stage.isFullScreen);
}

TEST(WalkPictures, AScreenshotHasNothingWrittenOverIt) {
  Walk walk;
  walk.stage.window = ImageSize{320, 200};
  walk.now(down(Key::H));
  walk.now(down(Key::F1));
  walk.now(down(Key::F12));
  walk.loop().awaitScreenshots();
  ASSERT_EQ(walk.stage.printed.size(), 1);
  const std::string line = walk.stage.printed[0];
  const std::string name = line.substr(6, line.find(':') - 6);
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
  EXPECT_EQ(*readImage(path, 1 << 20), walk.drawn(LightMode::Both, {320, 200}));
  EXPECT_NE(line.find(" --size 320x200 --light both"), std::string::npos) << line;
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace hearth
