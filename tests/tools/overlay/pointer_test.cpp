// Whose the mouse is: the picture's or the panel's.

#include "viewer/overlay/pointer.h"

#include <SDL_keyboard.h>
#include <gtest/gtest.h>

#include "walk/stage.h"

namespace hearth {
namespace {

using Kind = PointerEvent::Kind;

constexpr int kPanelLeft = 100;

SDL_Event button(Uint32 type, int x) {
  SDL_Event event{};
  event.type = type;
  event.button.button = SDL_BUTTON_LEFT;
  event.button.x = x;
  event.button.y = 7;
  return event;
}
SDL_Event press(int x) { return button(SDL_MOUSEBUTTONDOWN, x); }
SDL_Event release(int x) { return button(SDL_MOUSEBUTTONUP, x); }

SDL_Event moveTo(int x) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = x;
  event.motion.y = 7;
  return event;
}

TEST(PointerTest, BelongsToThePictureLeftOfThePanel) {
  Pointer pointer;
  const auto move = pointer.take(moveTo(99), kPanelLeft);
  ASSERT_TRUE(move);
  EXPECT_EQ(move->kind, Kind::Move);
  EXPECT_EQ(move->pixel, (Vec2{99, 7}));
  EXPECT_FALSE(pointer.take(moveTo(100), kPanelLeft));
  EXPECT_FALSE(pointer.take(press(100), kPanelLeft));
}

TEST(PointerTest, StaysWithThePictureUntilItIsLetGoOf) {
  Pointer pointer;
  EXPECT_EQ(pointer.take(press(50), kPanelLeft)->kind, Kind::Press);
  EXPECT_EQ(pointer.take(moveTo(150), kPanelLeft)->kind, Kind::Move);
  EXPECT_EQ(pointer.take(release(150), kPanelLeft)->kind, Kind::Release);
  EXPECT_FALSE(pointer.take(moveTo(150), kPanelLeft));
}

TEST(PointerTest, StaysWithThePanelUntilItIsLetGoOf) {
  Pointer pointer;
  EXPECT_FALSE(pointer.take(press(150), kPanelLeft));
  EXPECT_FALSE(pointer.take(moveTo(50), kPanelLeft));
  EXPECT_FALSE(pointer.take(release(50), kPanelLeft));
  EXPECT_TRUE(pointer.take(moveTo(50), kPanelLeft));
}

TEST(PointerTest, LeavesOtherButtonsAlone) {
  Pointer pointer;
  SDL_Event right = press(50);
  right.button.button = SDL_BUTTON_RIGHT;
  EXPECT_FALSE(pointer.take(right, kPanelLeft));
}

TEST(PointerTest, KnowsOfShift) {
  Pointer pointer;
  EXPECT_FALSE(pointer.take(test::down(SDL_SCANCODE_LSHIFT), kPanelLeft));
  EXPECT_TRUE(pointer.take(moveTo(1), kPanelLeft)->isShifted);
  EXPECT_FALSE(pointer.take(test::up(SDL_SCANCODE_LSHIFT), kPanelLeft));
  EXPECT_FALSE(pointer.take(moveTo(1), kPanelLeft)->isShifted);
}

SDL_Event letter(SDL_Keycode key, bool isDown, int modifiers = 0) {
  SDL_Event event = test::keyEvent(SDL_GetScancodeFromKey(key), isDown);
  event.key.keysym.sym = key;
  event.key.keysym.mod = static_cast<Uint16>(modifiers);
  return event;
}

TEST(PointerTest, KnowsTheAxisWhoseKeyIsHeld) {
  Pointer pointer;
  const auto axis = [&] { return pointer.take(moveTo(1), kPanelLeft)->axis; };
  pointer.take(letter(SDLK_x, true), kPanelLeft);
  EXPECT_EQ(axis(), Axis::X);
  pointer.take(letter(SDLK_z, true), kPanelLeft);
  EXPECT_EQ(axis(), Axis::Z);
  pointer.take(letter(SDLK_x, false), kPanelLeft);
  EXPECT_EQ(axis(), Axis::Z);
  pointer.take(letter(SDLK_z, false), kPanelLeft);
  EXPECT_FALSE(axis());
  pointer.take(letter(SDLK_z, true, KMOD_LCTRL), kPanelLeft);
  EXPECT_FALSE(axis()) << "which undoes";
}

}  // namespace
}  // namespace hearth
