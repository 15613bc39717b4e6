#pragma once

#include <functional>
#include <optional>
#include <string>

#include "image/pixel_rows.h"
#include "settings/options.h"
#include "viewer/input/event.h"

namespace hearth {

using DrawRows = std::function<void(const PixelRows&)>;

/// The window that shows and steers a walk. The program gives a real one, a test gives a list of
/// events and its own clock.
class WindowHost {
 public:
  virtual ~WindowHost() = default;

  /// The time of any clock.
  virtual double seconds() = 0;
  /// Takes the next event, if there is one. The mouse is at a pixel of the last picture.
  virtual std::optional<Event> poll() = 0;
  /// Sleeps until there is an event, or for so long.
  virtual void rest(double seconds) = 0;

  /// The size of the window in pixels; none while it cannot be seen.
  virtual std::optional<ImageSize> windowSize() = 0;
  /// Shows a picture of this size. `draw` writes all of it into the window's memory, and must not
  /// read that memory: it may be slow, or hold anything.
  virtual void show(ImageSize size, const DrawRows& draw) = 0;
  virtual void setTitle(const std::string& title) = 0;
  /// Hides the pointer, and reports motion of the mouse beyond the window's edges.
  virtual void captureMouse(bool isCaptured) = 0;
  virtual void toggleFullScreen() = 0;
  /// Puts text on the clipboard.
  virtual void copy(const std::string& text) = 0;
  /// The memory of the machine that the program holds, in bytes.
  virtual double residentBytes() = 0;
  /// Prints a line on the terminal.
  virtual void print(const std::string& line) = 0;
};

}  // namespace hearth
