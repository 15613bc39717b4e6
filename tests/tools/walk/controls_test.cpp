// From events to what is asked of the walker in a tick.

#include "viewer/walk/controls.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "stage.h"

namespace hearth {
namespace {

using test::axis;
using test::button;
using test::down;
using test::keyEvent;
using test::motion;
using test::up;

class ControlsTest : public testing::Test {
 protected:
  WalkInput tick() { return controls_.nextTick(1, 0); }

  Controls controls_;
};

TEST(KeyTable, HasKeysForEveryActionAndNoneTwice) {
  std::set<SDL_Scancode> codes;
  std::set<std::string_view> names;
  const KeyMap map;
  for (const ActionRow& row : actionTable()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(map.keysOf(row.action).empty()) << row.name;
    for (const SDL_Scancode key : map.keysOf(row.action)) {
      EXPECT_TRUE(codes.insert(key).second) << nameOf(key);
      EXPECT_EQ(map.actionOf(key), row.action);
    }
  }
  EXPECT_FALSE(map.actionOf(SDL_SCANCODE_UNKNOWN));
}

TEST(KeyTable, GivesAKeyToOneActionOnly) {
  KeyMap keys;
  keys.bind(Action::Jump, {SDL_SCANCODE_W, SDL_SCANCODE_J});
  EXPECT_EQ(keys.actionOf(SDL_SCANCODE_W), Action::Jump);
  EXPECT_EQ(keys.keysOf(Action::Forward), std::vector{SDL_SCANCODE_UP});
  EXPECT_FALSE(keys.actionOf(SDL_SCANCODE_SPACE));
}

std::string namesFor(const KeyMap& keys, std::string_view help) {
  for (const KeyListRow& row : keyList(keys))
    if (row.help == help) return row.names;
  ADD_FAILURE() << "no row " << help;
  return "";
}

TEST(KeyTable, ListsTheKeysThatThereAre) {
  KeyMap keys;
  EXPECT_EQ(namesFor(keys, "walk"), "W S, Up Down");
  EXPECT_EQ(namesFor(keys, "run"), "Shift");
  keys.bind(Action::Forward, {SDL_SCANCODE_E});
  keys.bind(Action::Fly, {SDL_SCANCODE_LSHIFT});
  keys.bind(Action::Jump, {});
  EXPECT_EQ(namesFor(keys, "walk"), "E S, Down");
  EXPECT_EQ(namesFor(keys, "fly, or walk again"), "Left Shift");
  EXPECT_EQ(namesFor(keys, "run"), "Right Shift") << "one of them alone";
  EXPECT_EQ(namesFor(keys, "jump; in flight: up"), "no key");
}

TEST_F(ControlsTest, NothingIsAskedForByNothing) { EXPECT_EQ(tick(), WalkInput{}); }

TEST_F(ControlsTest, KeysAskForAsLongAsTheyAreHeld) {
  controls_.take(down(SDL_SCANCODE_W));
  controls_.take(down(SDL_SCANCODE_LSHIFT));
  for (int i = 0; i < 2; ++i) EXPECT_EQ(tick(), (WalkInput{.forward = 127, .run = true}));
  controls_.take(up(SDL_SCANCODE_W));
  EXPECT_EQ(tick(), WalkInput{.run = true});
}

TEST_F(ControlsTest, ArrowsWalkAndTurn) {
  controls_.take(down(SDL_SCANCODE_DOWN));
  controls_.take(down(SDL_SCANCODE_LEFT));
  controls_.take(down(SDL_SCANCODE_PAGEUP));
  EXPECT_EQ(tick(), (WalkInput{.forward = -127, .turn = -2000, .pitch = 1000}));
}

TEST_F(ControlsTest, OppositeKeysCancel) {
  for (const SDL_Scancode code : {SDL_SCANCODE_W, SDL_SCANCODE_S, SDL_SCANCODE_A, SDL_SCANCODE_D,
                                  SDL_SCANCODE_LEFT, SDL_SCANCODE_RIGHT})
    controls_.take(down(code));
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, TwoKeysOfOneActionAreHeldUntilBothAreLetGo) {
  controls_.take(down(SDL_SCANCODE_W));
  controls_.take(down(SDL_SCANCODE_UP));
  controls_.take(up(SDL_SCANCODE_W));
  EXPECT_EQ(tick().forward, 127);
  controls_.take(up(SDL_SCANCODE_UP));
  EXPECT_EQ(tick().forward, 0);
}

TEST_F(ControlsTest, AKeyThatIsLetGoBeforeTheTickCountsForOne) {
  controls_.take(down(SDL_SCANCODE_SPACE));
  controls_.take(up(SDL_SCANCODE_SPACE));
  EXPECT_TRUE(tick().jump);
  EXPECT_FALSE(tick().jump);
}

TEST_F(ControlsTest, FlightIsToggledOncePerPress) {
  EXPECT_EQ(controls_.take(down(SDL_SCANCODE_N)), Action::Fly);
  EXPECT_FALSE(controls_.take(keyEvent(SDL_SCANCODE_N, true, true)));
  EXPECT_TRUE(tick().toggleFlight);
  EXPECT_FALSE(tick().toggleFlight);
}

TEST_F(ControlsTest, JumpAndCrouchAreUpAndDownInFlight) {
  controls_.take(down(SDL_SCANCODE_C));
  EXPECT_EQ(tick(), (WalkInput{.up = -127, .crouch = true}));
  controls_.take(up(SDL_SCANCODE_C));
  controls_.take(down(SDL_SCANCODE_SPACE));
  EXPECT_EQ(tick(), (WalkInput{.up = 127, .jump = true}));
}

TEST_F(ControlsTest, KeysOfTheDesktopAreNotTheWalkers) {
  SDL_Event altTab = down(SDL_SCANCODE_TAB);
  altTab.key.keysym.mod = KMOD_LALT;
  EXPECT_FALSE(controls_.take(altTab));
  EXPECT_EQ(controls_.take(down(SDL_SCANCODE_TAB)), Action::Map);
}

TEST_F(ControlsTest, LookingAheadUndoesThePitch) {
  controls_.take(down(SDL_SCANCODE_HOME));
  EXPECT_EQ(controls_.nextTick(1, 12.345).pitch, -12345);
}

TEST_F(ControlsTest, TheMouseLooksOnlyWhileItIsCaptured) {
  controls_.take(motion(10, 0));
  EXPECT_EQ(tick(), WalkInput{});
  controls_.captureMouse(true);
  controls_.take(motion(10, -4));
  EXPECT_EQ(tick(), (WalkInput{.turn = 1500, .pitch = 600}));
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, TheMouseMovesAsFarAndTheWayThatTheUserLikes) {
  controls_.setPreferences({.degreesPerPixel = 0.04, .invertsPitch = true});
  controls_.captureMouse(true);
  controls_.take(motion(10, -4));
  EXPECT_EQ(tick(), (WalkInput{.turn = 400, .pitch = -160}));
}

TEST_F(ControlsTest, KeysDoWhatTheUserSays) {
  Preferences preferences;
  preferences.keys.bind(Action::Forward, {SDL_SCANCODE_E});
  controls_.take(down(SDL_SCANCODE_S));
  controls_.setPreferences(preferences);
  EXPECT_EQ(tick(), WalkInput{}) << "what was held is let go of";
  controls_.take(down(SDL_SCANCODE_W));
  EXPECT_EQ(tick(), WalkInput{});
  controls_.take(down(SDL_SCANCODE_E));
  EXPECT_EQ(tick().forward, 127);
}

TEST_F(ControlsTest, MotionIsSpreadOverTheTicksAndNoneIsLost) {
  controls_.captureMouse(true);
  for (const int pixels : {1, 7, -5, 100}) {
    controls_.take(motion(pixels, pixels));
    WalkInput sum;
    for (int due = 7; due > 0; --due) {
      const WalkInput input = controls_.nextTick(due, 0);
      EXPECT_NEAR(input.turn, 150.0 * pixels / 7, 1);
      sum.turn += input.turn;
      sum.pitch += input.pitch;
    }
    EXPECT_EQ(sum, (WalkInput{.turn = 150 * pixels, .pitch = -150 * pixels}));
  }
}

TEST_F(ControlsTest, AWildMouseDoesNotOverflow) {
  controls_.captureMouse(true);
  for (int i = 0; i < 10000; ++i) controls_.take(motion(2147483647, -2147483647 - 1));
  const WalkInput input = tick();
  EXPECT_GT(input.turn, 0);
  EXPECT_GT(input.pitch, 0);
}

TEST_F(ControlsTest, ReleaseLetsGoOfEverything) {
  controls_.captureMouse(true);
  controls_.take(down(SDL_SCANCODE_W));
  controls_.take(motion(10, 10));
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTX, 32767));
  controls_.take(button(SDL_CONTROLLER_BUTTON_A, true));
  controls_.release();
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, SticksWalkAndLook) {
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTY, -32768));
  controls_.take(axis(SDL_CONTROLLER_AXIS_RIGHTX, 32767));
  EXPECT_EQ(tick(), (WalkInput{.forward = 127, .turn = 3000}));
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTY, 0));
  controls_.take(axis(SDL_CONTROLLER_AXIS_RIGHTX, 0));
  controls_.take(axis(SDL_CONTROLLER_AXIS_RIGHTY, 32767));
  EXPECT_EQ(tick(), WalkInput{.pitch = -1500});
}

TEST_F(ControlsTest, AStickThatRestsOffItsMiddleIsStill) {
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTX, 5000));
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTY, -5000));
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, AStickIsAsFastInEveryDirection) {
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTX, 32767));
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTY, -32767));
  const WalkInput input = tick();
  EXPECT_EQ(input.forward, 90);  // 127 / sqrt(2)
  EXPECT_EQ(input.right, 90);
}

TEST_F(ControlsTest, AStickAndAKeyTogetherAreNoFaster) {
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTY, -32767));
  controls_.take(down(SDL_SCANCODE_W));
  EXPECT_EQ(tick().forward, 127);
}

TEST_F(ControlsTest, ButtonsAndTriggersDoWhatKeysDo) {
  EXPECT_EQ(controls_.take(button(SDL_CONTROLLER_BUTTON_Y, true)), Action::Fly);
  controls_.take(button(SDL_CONTROLLER_BUTTON_A, true));
  controls_.take(axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767));
  EXPECT_EQ(tick(), (WalkInput{.up = 127, .run = true, .jump = true, .toggleFlight = true}));
  controls_.take(button(SDL_CONTROLLER_BUTTON_A, false));
  EXPECT_EQ(tick(), WalkInput{.run = true});
}

TEST_F(ControlsTest, AGamepadThatIsPulledOutLetsGo) {
  controls_.take(axis(SDL_CONTROLLER_AXIS_LEFTY, -32767));
  controls_.take(button(SDL_CONTROLLER_BUTTON_B, true));
  SDL_Event removed{};
  removed.type = SDL_CONTROLLERDEVICEREMOVED;
  controls_.take(removed);
  tick();  // the button was pressed before it
  EXPECT_EQ(tick(), WalkInput{});
}

}  // namespace
}  // namespace hearth
