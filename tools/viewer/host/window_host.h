#pragma once

#include <functional>
#include <optional>
#include <string>

#include "image/pixel_rows.h"
#include "settings/options.h"
#include "viewer/input/event.h"

namespace hearth {

using DrawRows = std::function<void(const PixelRows&)>;

/// What a walk is shown in and steered from. The program gives it a window, a test a list of events
/// and a clock of its own.
class WindowHost {
 public:
  virtual ~WindowHost() = default;

  /// Of any clock.
  virtual double seconds() = 0;
  /// Takes the next event, if there is one. The mouse is at a pixel of the last picture.
  virtual std::optional<Event> poll() = 0;
  /// Sleeps until an event is there, or for so long.
  virtual void rest(double seconds) = 0;

  /// The window in pixels; nothing while it cannot be seen.
  virtual std::optional<PictureSize> windowSize() = 0;
  /// A picture of this size that `draw` writes, all of it, into memory of the window's. That is not
  /// to be read: it may be slow, or hold anything.
  virtual void show(PictureSize size, const DrawRows& draw) = 0;
  virtual void setTitle(const std::string& title) = 0;
  /// Hides the pointer and reports the mouse's motion without end.
  virtual void captureMouse(bool isCaptured) = 0;
  virtual void toggleFullScreen() = 0;
  /// Puts text on the clipboard.
  virtual void copy(const std::string& text) = 0;
  /// What the program holds of the machine's memory.
  virtual double residentBytes() = 0;
  /// A line on the terminal.
  virtual void print(const std::string& line) = 0;
};

}  // namespace hearth
