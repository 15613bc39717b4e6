#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "image/pixel_rows.h"
#include "viewer/host/window_host.h"
#include "viewer/input/event.h"

namespace hearth::test {

/// A world outside that stands still unless a test moves it: its clock, its events, its window.
class Stage : public WindowHost {
 public:
  double seconds() override { return now; }
  std::optional<Event> poll() override {
    if (taken_ < events.size()) return events[taken_++];
    events.clear();
    taken_ = 0;
    return std::nullopt;
  }
  void rest(double) override { ++rests; }
  std::optional<ImageSize> windowSize() override { return window; }
  void show(ImageSize size, const DrawRows& draw) override {
    const PixelRows rows = memory_.rows(size.width, size.height);
    draw(rows);
    if (shown.width() != size.width || shown.height() != size.height)
      shown = Image(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) shown.at(x, y) = fromXrgb(*rows.at(x, y));
    ++frames;
  }
  void setTitle(const std::string& text) override { title = text; }
  void captureMouse(bool isCaptured) override { isMouseCaptured = isCaptured; }
  void toggleFullScreen() override { isFullScreen = !isFullScreen; }
  void copy(const std::string& text) override { clipboard = text; }
  double residentBytes() override { return 0; }
  void print(const std::string& line) override { printed.push_back(line); }

  double now = 1000;
  std::vector<Event> events;  ///< to come
  std::optional<ImageSize> window = ImageSize{64, 40};

  Image shown;
  int frames = 0;
  int rests = 0;
  std::string title;
  bool isMouseCaptured = false;
  bool isFullScreen = false;
  std::vector<std::string> printed;
  std::string clipboard;

 private:
  std::size_t taken_ = 0;
  PixelBuffer memory_;
};

inline Event down(Key key) { return KeyEvent{.key = key}; }
inline Event up(Key key) { return KeyEvent{.key = key, .isDown = false}; }

inline Event motion(int right, int downwards) {
  return MouseMotion{.right = right, .down = downwards};
}

/// The mouse at a pixel.
inline Event moveTo(int x, int y) { return MouseMotion{.x = x, .y = y}; }
inline Event pressAt(int x, int y, MouseButton button = MouseButton::Left) {
  return MouseButtonEvent{button, true, x, y};
}
inline Event releaseAt(int x, int y, MouseButton button = MouseButton::Left) {
  return MouseButtonEvent{button, false, x, y};
}
inline std::array<Event, 2> clickAt(int x, int y) { return {pressAt(x, y), releaseAt(x, y)}; }
inline Event click() { return pressAt(0, 0); }

}  // namespace hearth::test
