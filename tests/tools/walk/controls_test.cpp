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

using test::down;
using test::motion;
using test::up;

class ControlsTest : public testing::Test {
 protected:
  WalkInput tick() { return controls_.nextTick(1, 0); }

  Controls controls_;
};

TEST(KeyTable, HasKeysForEveryActionAndNoneTwice) {
  std::set<Key> codes;
  std::set<std::string_view> names;
  const KeyMap map;
  for (const ActionRow& row : actionTable()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(map.keysOf(row.action).empty()) << row.name;
    for (const Key key : map.keysOf(row.action)) {
      EXPECT_TRUE(codes.insert(key).second) << nameOf(key);
      EXPECT_EQ(map.actionOf(key), row.action);
    }
  }
  EXPECT_FALSE(map.actionOf(Key::None));
}

TEST(KeyTable, GivesAKeyToOneActionOnly) {
  KeyMap keys;
  keys.bind(Action::Jump, {Key::W, Key::J});
  EXPECT_EQ(keys.actionOf(Key::W), Action::Jump);
  EXPECT_EQ(keys.keysOf(Action::Forward), std::vector{Key::Up});
  EXPECT_FALSE(keys.actionOf(Key::Space));
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
  keys.bind(Action::Forward, {Key::E});
  keys.bind(Action::Fly, {Key::LeftShift});
  keys.bind(Action::Jump, {});
  EXPECT_EQ(namesFor(keys, "walk"), "E S, Down");
  EXPECT_EQ(namesFor(keys, "fly, or walk again"), "Left Shift");
  EXPECT_EQ(namesFor(keys, "run"), "Right Shift") << "one of them alone";
  EXPECT_EQ(namesFor(keys, "jump; in flight: up"), "no key");
}

TEST_F(ControlsTest, NothingIsAskedForByNothing) { EXPECT_EQ(tick(), WalkInput{}); }

TEST_F(ControlsTest, KeysAskForAsLongAsTheyAreHeld) {
  controls_.handle(down(Key::W));
  controls_.handle(down(Key::LeftShift));
  for (int i = 0; i < 2; ++i) EXPECT_EQ(tick(), (WalkInput{.forward = 127, .run = true}));
  controls_.handle(up(Key::W));
  EXPECT_EQ(tick(), WalkInput{.run = true});
}

TEST_F(ControlsTest, ArrowsWalkAndTurn) {
  controls_.handle(down(Key::Down));
  controls_.handle(down(Key::Left));
  controls_.handle(down(Key::PageUp));
  EXPECT_EQ(tick(), (WalkInput{.forward = -127, .turn = -2000, .pitch = 1000}));
}

TEST_F(ControlsTest, OppositeKeysCancel) {
  for (const Key code : {Key::W, Key::S, Key::A, Key::D, Key::Left, Key::Right})
    controls_.handle(down(code));
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, TwoKeysOfOneActionAreHeldUntilBothAreLetGo) {
  controls_.handle(down(Key::W));
  controls_.handle(down(Key::Up));
  controls_.handle(up(Key::W));
  EXPECT_EQ(tick().forward, 127);
  controls_.handle(up(Key::Up));
  EXPECT_EQ(tick().forward, 0);
}

TEST_F(ControlsTest, AKeyThatIsLetGoBeforeTheTickCountsForOne) {
  controls_.handle(down(Key::Space));
  controls_.handle(up(Key::Space));
  EXPECT_TRUE(tick().jump);
  EXPECT_FALSE(tick().jump);
}

TEST_F(ControlsTest, FlightIsToggledOncePerPress) {
  EXPECT_EQ(controls_.handle(down(Key::N)), Action::Fly);
  EXPECT_FALSE(controls_.handle(KeyEvent{.key = Key::N, .isRepeat = true}));
  EXPECT_TRUE(tick().toggleFlight);
  EXPECT_FALSE(tick().toggleFlight);
}

TEST_F(ControlsTest, JumpAndCrouchAreUpAndDownInFlight) {
  controls_.handle(down(Key::C));
  EXPECT_EQ(tick(), (WalkInput{.up = -127, .crouch = true}));
  controls_.handle(up(Key::C));
  controls_.handle(down(Key::Space));
  EXPECT_EQ(tick(), (WalkInput{.up = 127, .jump = true}));
}

TEST_F(ControlsTest, KeysOfTheDesktopAreNotTheWalkers) {
  EXPECT_FALSE(controls_.handle(KeyEvent{.key = Key::Tab, .hasAlt = true}));
  EXPECT_EQ(controls_.handle(down(Key::Tab)), Action::Map);
}

TEST_F(ControlsTest, LookingAheadUndoesThePitch) {
  controls_.handle(down(Key::Home));
  EXPECT_EQ(controls_.nextTick(1, 12.345).pitch, -12345);
}

TEST_F(ControlsTest, TheMouseLooksOnlyWhileItIsCaptured) {
  controls_.handle(motion(10, 0));
  EXPECT_EQ(tick(), WalkInput{});
  controls_.captureMouse(true);
  controls_.handle(motion(10, -4));
  EXPECT_EQ(tick(), (WalkInput{.turn = 1500, .pitch = 600}));
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, TheMouseMovesAsFarAndTheWayThatTheUserLikes) {
  controls_.setPreferences({.degreesPerPixel = 0.04, .invertsPitch = true});
  controls_.captureMouse(true);
  controls_.handle(motion(10, -4));
  EXPECT_EQ(tick(), (WalkInput{.turn = 400, .pitch = -160}));
}

TEST_F(ControlsTest, KeysDoWhatTheUserSays) {
  Preferences preferences;
  preferences.keys.bind(Action::Forward, {Key::E});
  controls_.handle(down(Key::S));
  controls_.setPreferences(preferences);
  EXPECT_EQ(tick(), WalkInput{}) << "what was held is let go of";
  controls_.handle(down(Key::W));
  EXPECT_EQ(tick(), WalkInput{});
  controls_.handle(down(Key::E));
  EXPECT_EQ(tick().forward, 127);
}

TEST_F(ControlsTest, MotionIsSpreadOverTheTicksAndNoneIsLost) {
  controls_.captureMouse(true);
  for (const int pixels : {1, 7, -5, 100}) {
    controls_.handle(motion(pixels, pixels));
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
  for (int i = 0; i < 10000; ++i) controls_.handle(motion(2147483647, -2147483647 - 1));
  const WalkInput input = tick();
  EXPECT_GT(input.turn, 0);
  EXPECT_GT(input.pitch, 0);
}

TEST_F(ControlsTest, ReleaseLetsGoOfEverything) {
  controls_.captureMouse(true);
  controls_.handle(down(Key::W));
  controls_.handle(motion(10, 10));
  controls_.handle(GamepadMotion{GamepadAxis::LeftX, 32767});
  controls_.handle(GamepadButtonEvent{GamepadButton::A, true});
  controls_.release();
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, SticksWalkAndLook) {
  controls_.handle(GamepadMotion{GamepadAxis::LeftY, -32768});
  controls_.handle(GamepadMotion{GamepadAxis::RightX, 32767});
  EXPECT_EQ(tick(), (WalkInput{.forward = 127, .turn = 3000}));
  controls_.handle(GamepadMotion{GamepadAxis::LeftY, 0});
  controls_.handle(GamepadMotion{GamepadAxis::RightX, 0});
  controls_.handle(GamepadMotion{GamepadAxis::RightY, 32767});
  EXPECT_EQ(tick(), WalkInput{.pitch = -1500});
}

TEST_F(ControlsTest, AStickThatRestsOffItsMiddleIsStill) {
  controls_.handle(GamepadMotion{GamepadAxis::LeftX, 5000});
  controls_.handle(GamepadMotion{GamepadAxis::LeftY, -5000});
  EXPECT_EQ(tick(), WalkInput{});
}

TEST_F(ControlsTest, AStickIsAsFastInEveryDirection) {
  controls_.handle(GamepadMotion{GamepadAxis::LeftX, 32767});
  controls_.handle(GamepadMotion{GamepadAxis::LeftY, -32767});
  const WalkInput input = tick();
  EXPECT_EQ(input.forward, 90);  // 127 / sqrt(2)
  EXPECT_EQ(input.right, 90);
}

TEST_F(ControlsTest, AStickAndAKeyTogetherAreNoFaster) {
  controls_.handle(GamepadMotion{GamepadAxis::LeftY, -32767});
  controls_.handle(down(Key::W));
  EXPECT_EQ(tick().forward, 127);
}

TEST_F(ControlsTest, ButtonsAndTriggersDoWhatKeysDo) {
  EXPECT_EQ(controls_.handle(GamepadButtonEvent{GamepadButton::Y, true}), Action::Fly);
  controls_.handle(GamepadButtonEvent{GamepadButton::A, true});
  controls_.handle(GamepadMotion{GamepadAxis::RightTrigger, 32767});
  EXPECT_EQ(tick(), (WalkInput{.up = 127, .run = true, .jump = true, .toggleFlight = true}));
  controls_.handle(GamepadButtonEvent{GamepadButton::A, false});
  EXPECT_EQ(tick(), WalkInput{.run = true});
}

TEST_F(ControlsTest, AGamepadThatIsPulledOutLetsGo) {
  controls_.handle(GamepadMotion{GamepadAxis::LeftY, -32767});
  controls_.handle(GamepadButtonEvent{GamepadButton::B, true});
  controls_.handle(GamepadRemoved{});
  tick();  // the button was pressed before it
  EXPECT_EQ(tick(), WalkInput{});
}

}  // namespace
}  // namespace hearth
