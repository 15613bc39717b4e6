// Whose the mouse is: the picture's or the panel's.

#include "viewer/overlay/pointer.h"

#include <gtest/gtest.h>

#include "walk/stage.h"

namespace hearth {
namespace {

using Kind = PointerEvent::Kind;

constexpr int kPanelLeft = 100;

Event press(int x) { return test::pressAt(x, 7); }
Event release(int x) { return test::releaseAt(x, 7); }
Event moveTo(int x) { return test::moveTo(x, 7); }

TEST(PointerTest, BelongsToThePictureLeftOfThePanel) {
  Pointer pointer;
  const auto move = pointer.handle(moveTo(99), kPanelLeft);
  ASSERT_TRUE(move);
  EXPECT_EQ(move->kind, Kind::Move);
  EXPECT_EQ(move->pixel, (Vec2{99, 7}));
  EXPECT_FALSE(pointer.handle(moveTo(100), kPanelLeft));
  EXPECT_FALSE(pointer.handle(press(100), kPanelLeft));
}

TEST(PointerTest, StaysWithThePictureUntilItIsLetGoOf) {
  Pointer pointer;
  EXPECT_EQ(pointer.handle(press(50), kPanelLeft)->kind, Kind::Press);
  EXPECT_EQ(pointer.handle(moveTo(150), kPanelLeft)->kind, Kind::Move);
  EXPECT_EQ(pointer.handle(release(150), kPanelLeft)->kind, Kind::Release);
  EXPECT_FALSE(pointer.handle(moveTo(150), kPanelLeft));
}

TEST(PointerTest, StaysWithThePanelUntilItIsLetGoOf) {
  Pointer pointer;
  EXPECT_FALSE(pointer.handle(press(150), kPanelLeft));
  EXPECT_FALSE(pointer.handle(moveTo(50), kPanelLeft));
  EXPECT_FALSE(pointer.handle(release(50), kPanelLeft));
  EXPECT_TRUE(pointer.handle(moveTo(50), kPanelLeft));
}

TEST(PointerTest, LeavesOtherButtonsAlone) {
  Pointer pointer;
  EXPECT_FALSE(pointer.handle(test::pressAt(50, 7, MouseButton::Right), kPanelLeft));
}

TEST(PointerTest, KnowsOfShift) {
  Pointer pointer;
  EXPECT_FALSE(pointer.handle(test::down(Key::LeftShift), kPanelLeft));
  EXPECT_TRUE(pointer.handle(moveTo(1), kPanelLeft)->isShifted);
  EXPECT_FALSE(pointer.handle(test::up(Key::LeftShift), kPanelLeft));
  EXPECT_FALSE(pointer.handle(moveTo(1), kPanelLeft)->isShifted);
}

TEST(PointerTest, KnowsTheAxisWhoseKeyIsHeld) {
  Pointer pointer;
  const auto axis = [&] { return pointer.handle(moveTo(1), kPanelLeft)->axis; };
  pointer.handle(KeyEvent{.letter = 'x'}, kPanelLeft);
  EXPECT_EQ(axis(), Axis::X);
  pointer.handle(KeyEvent{.letter = 'z'}, kPanelLeft);
  EXPECT_EQ(axis(), Axis::Z);
  pointer.handle(KeyEvent{.isDown = false, .letter = 'x'}, kPanelLeft);
  EXPECT_EQ(axis(), Axis::Z);
  pointer.handle(KeyEvent{.isDown = false, .letter = 'z'}, kPanelLeft);
  EXPECT_FALSE(axis());
  pointer.handle(KeyEvent{.letter = 'z', .hasCtrl = true}, kPanelLeft);
  EXPECT_FALSE(axis()) << "which undoes";
}

}  // namespace
}  // namespace hearth
