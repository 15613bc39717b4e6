// The window with SDL's own events, on a video driver that shows nothing.

#include "desktop/window.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <variant>

#include "viewer/walk/controls.h"

namespace hearth {
namespace {

class HiddenWindow : public testing::Test {
 protected:
  HiddenWindow() {
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    setenv("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1", 1);  // the window never has the focus
  }

  static void deliver(WalkWindow& window, Controls& controls) {
    SDL_JoystickUpdate();
    while (const auto event = window.poll()) controls.handle(*event);
  }
};

void showColor(WalkWindow& window, ImageSize size, Uint32 color) {
  window.show(size, [color](const PixelRows& rows) {
    for (int y = 0; y < rows.height; ++y) std::fill_n(rows.at(0, y), rows.width, color);
  });
}

TEST_F(HiddenWindow, AGamepadThatIsPluggedInWalks) {
  auto window = WalkWindow::open("test", {});
  ASSERT_TRUE(window) << window.error();
  Controls controls;
  deliver(*window, controls);
  const int index = SDL_JoystickAttachVirtual(
      SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
  ASSERT_GE(index, 0) << SDL_GetError();
  deliver(*window, controls);  // which opens it
  SDL_Joystick* gamepad = SDL_JoystickOpen(index);
  SDL_JoystickSetVirtualAxis(gamepad, SDL_CONTROLLER_AXIS_LEFTY, -32768);
  SDL_JoystickSetVirtualAxis(gamepad, SDL_CONTROLLER_AXIS_RIGHTX, 32767);
  SDL_JoystickSetVirtualButton(gamepad, SDL_CONTROLLER_BUTTON_A, 1);
  deliver(*window, controls);
  const WalkInput input = controls.nextTick(1, 0);
  EXPECT_EQ(input.forward, kFullSpeed);
  EXPECT_EQ(input.turn, 3000);
  EXPECT_TRUE(input.jump);

  SDL_JoystickClose(gamepad);
  SDL_JoystickDetachVirtual(index);
  deliver(*window, controls);
  controls.nextTick(1, 0);
  EXPECT_EQ(controls.nextTick(1, 0), WalkInput{});
}

TEST_F(HiddenWindow, TakesPicturesOfAnySize) {
  auto window = WalkWindow::open("test", {});
  ASSERT_TRUE(window) << window.error();
  EXPECT_EQ(window->windowSize(), kFirstWindowSize);
  for (const ImageSize size : {ImageSize{1, 1}, {4000, 3}, {960, 600}, {7, 2000}})
    showColor(*window, size, 0);
}

/// What lies in the middle of the only window.
Uint32 middleOfWindow() {
  SDL_Window* window = nullptr;
  for (Uint32 id = 0; !window && id < 100; ++id) window = SDL_GetWindowFromID(id);
  const SDL_Surface* surface = SDL_GetWindowSurface(window);
  const auto* row = static_cast<const Uint8*>(surface->pixels) + surface->h / 2 * surface->pitch;
  return reinterpret_cast<const Uint32*>(row)[surface->w / 2] & 0xFFFFFF;
}

TEST_F(HiddenWindow, ShowsWhatIsDrawnInItsSizeAndInOthers) {
  auto window = WalkWindow::open("test", {});
  ASSERT_TRUE(window) << window.error();
  Uint32 color = 0x123456;
  for (const ImageSize size : {kFirstWindowSize, ImageSize{64, 40}, {3000, 2000}}) {
    color += 0x111111;
    showColor(*window, size, color);
    EXPECT_EQ(middleOfWindow(), color) << size.width;
  }
}

TEST_F(HiddenWindow, TellsTheMousesPlaceInThePicture) {
  WindowSettings settings;
  settings.windowSize = ImageSize{700, 400};  // twice the picture, 30 pixels from its left
  auto window = WalkWindow::open("test", settings);
  ASSERT_TRUE(window) << window.error();
  showColor(*window, {320, 200}, 0);
  while (window->poll()) continue;
  const auto placeOf = [&window](Uint32 type, int x, int y) {
    SDL_Event event{};
    event.type = type;
    (type == SDL_MOUSEMOTION ? event.motion.x : event.button.x) = x;
    (type == SDL_MOUSEMOTION ? event.motion.y : event.button.y) = y;
    SDL_PushEvent(&event);
    std::optional<Event>
        polled;  // SDL tells the end of a batch of events by a call that finds none
    for (int i = 0; i < 3 && !polled; ++i) polled = window->poll();
    EXPECT_TRUE(polled);
    if (!polled) return std::pair{0, 0};
    const auto* motion = std::get_if<MouseMotion>(&*polled);
    const auto* button = std::get_if<MouseButtonEvent>(&*polled);
    EXPECT_TRUE(motion || button);
    return motion ? std::pair{motion->x, motion->y} : std::pair{button->x, button->y};
  };
  for (const Uint32 type : {SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP}) {
    EXPECT_EQ(placeOf(type, 30, 0), (std::pair{0, 0}));
    EXPECT_EQ(placeOf(type, 31, 1), (std::pair{0, 0}));
    EXPECT_EQ(placeOf(type, 669, 399), (std::pair{319, 199}));
    EXPECT_EQ(placeOf(type, 29, 200), (std::pair{-1, 100}));
  }
}

TEST_F(HiddenWindow, IsAWholeNumberOfTimesAsLargeAsItsPicture) {
  WindowSettings settings;
  settings.pictureSize = ImageSize{320, 200};
  EXPECT_EQ(WalkWindow::open("test", settings)->windowSize(), (ImageSize{960, 600}));
  settings.pictureSize = ImageSize{400, 600};
  EXPECT_EQ(WalkWindow::open("test", settings)->windowSize(), (ImageSize{400, 600}));
}

TEST_F(HiddenWindow, IsNoLargerThanTheScreenAndKeepsThePicturesShape) {
  WindowSettings settings;  // the screen of this driver has 1024x768 pixels
  settings.pictureSize = ImageSize{1600, 800};
  EXPECT_EQ(WalkWindow::open("test", settings)->windowSize(), (ImageSize{1024, 512}));
  settings.pictureSize = ImageSize{100, 4096};
  EXPECT_EQ(WalkWindow::open("test", settings)->windowSize(), (ImageSize{19, 768}));
}

TEST_F(HiddenWindow, OpensWhereTheLastOneWasLeft) {
  WindowSettings settings;
  settings.place = WindowPlace{100, 50, {500, 300}};
  EXPECT_EQ(WalkWindow::open("test", settings)->place(), *settings.place);
  settings.place = WindowPlace{900, -20, {2000, 300}};
  EXPECT_EQ(WalkWindow::open("test", settings)->place(), (WindowPlace{0, 0, {1024, 300}}));
}

TEST_F(HiddenWindow, GoesBackFromTheFullScreenToWhereItWas) {
  WindowSettings settings;
  settings.place = WindowPlace{100, 50, {500, 300}, true};
  auto window = WalkWindow::open("test", settings);
  EXPECT_EQ(window->place(), *settings.place);
  EXPECT_EQ(window->windowSize(), (ImageSize{1024, 768}));
  window->toggleFullScreen();
  EXPECT_EQ(window->place(), (WindowPlace{100, 50, {500, 300}}));
}

TEST_F(HiddenWindow, IsAsLargeAsIsAskedForWhateverTheScreen) {
  WindowSettings settings;
  settings.windowSize = ImageSize{1920, 1080};
  EXPECT_EQ(WalkWindow::open("test", settings)->windowSize(), (ImageSize{1920, 1080}));
}

}  // namespace
}  // namespace hearth
