#pragma once

#include <SDL_events.h>

#include <string>
#include <vector>

#include "viewer/walk/window_host.h"

namespace hearth::test {

/// A world outside that stands still unless a test moves it: its clock, its events, its window.
class Stage : public WindowHost {
 public:
  double seconds() override { return now; }
  bool poll(SDL_Event& event) override {
    if (taken_ < events.size()) {
      event = events[taken_++];
      return true;
    }
    events.clear();
    taken_ = 0;
    return false;
  }
  void rest(double) override { ++rests; }
  std::optional<PictureSize> windowSize() override { return window; }
  void show(const Image& picture) override {
    shown = picture;
    ++frames;
  }
  void show(PictureSize size, const DrawRows& draw) override {
    const auto width = static_cast<std::size_t>(size.width);
    rows_.resize(width * static_cast<std::size_t>(size.height));
    const PixelRows rows{rows_.data(), width, size.width, size.height};
    draw(rows);
    shown = Image(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) shown.at(x, y) = colorAt(rows, x, y);
    ++frames;
  }
  void setTitle(const std::string& text) override { title = text; }
  void captureMouse(bool isCaptured) override { isMouseCaptured = isCaptured; }
  void toggleFullScreen() override { isFullScreen = !isFullScreen; }
  void copy(const std::string& text) override { clipboard = text; }
  void print(const std::string& line) override { printed.push_back(line); }

  double now = 1000;
  std::vector<SDL_Event> events;  ///< to come
  std::optional<PictureSize> window = PictureSize{64, 40};

  Image shown;
  int frames = 0;
  int rests = 0;
  std::string title;
  bool isMouseCaptured = false;
  bool isFullScreen = false;
  std::vector<std::string> printed;
  std::string clipboard;

 private:
  static Rgb colorAt(const PixelRows& rows, int x, int y) {
    const std::uint32_t pixel = *rows.at(x, y);
    return {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
            static_cast<std::uint8_t>(pixel)};
  }

  std::size_t taken_ = 0;
  std::vector<std::uint32_t> rows_;
};

inline SDL_Event keyEvent(SDL_Scancode code, bool isDown, bool isRepeat = false) {
  SDL_Event event{};
  event.type = isDown ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.scancode = code;
  event.key.repeat = isRepeat ? 1 : 0;
  return event;
}
inline SDL_Event down(SDL_Scancode code) { return keyEvent(code, true); }
inline SDL_Event up(SDL_Scancode code) { return keyEvent(code, false); }

inline SDL_Event click() {
  SDL_Event event{};
  event.type = SDL_MOUSEBUTTONDOWN;
  return event;
}

/// The mouse at a pixel: it moves there, or a button is pressed or let go of.
inline SDL_Event mouseAt(Uint32 type, int x, int y, Uint8 button = SDL_BUTTON_LEFT) {
  SDL_Event event{};
  event.type = type;
  if (type == SDL_MOUSEMOTION) {
    event.motion.x = x;
    event.motion.y = y;
  } else {
    event.button.button = button;
    event.button.x = x;
    event.button.y = y;
  }
  return event;
}

inline SDL_Event motion(int right, int downwards) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.xrel = right;
  event.motion.yrel = downwards;
  return event;
}

inline SDL_Event windowEvent(SDL_WindowEventID id) {
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.event = static_cast<Uint8>(id);
  return event;
}

inline SDL_Event axis(SDL_GameControllerAxis id, int value) {
  SDL_Event event{};
  event.type = SDL_CONTROLLERAXISMOTION;
  event.caxis.axis = static_cast<Uint8>(id);
  event.caxis.value = static_cast<Sint16>(value);
  return event;
}

inline SDL_Event button(SDL_GameControllerButton id, bool isDown) {
  SDL_Event event{};
  event.type = isDown ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
  event.cbutton.button = static_cast<Uint8>(id);
  return event;
}

}  // namespace hearth::test
