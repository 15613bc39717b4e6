#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "settings/options.h"

namespace hearth {

/// Where a window lies on the desktop, in its points.
struct WindowPlace {
  int x = 0;  ///< of its left top corner, without what the desktop draws round it
  int y = 0;
  ImageSize size{};
  bool isFullScreen = false;  ///< then the rest is what it goes back to

  friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

/// A part of the desktop that windows may cover.
struct Screen {
  int x;
  int y;
  int width;
  int height;
};

/// The place moved wholly onto the screen with most of it, and no larger than that screen. If it
/// lies on no screen, because one was removed, it moves to the first. Without screens it stays as
/// it is.
WindowPlace onScreen(WindowPlace place, std::span<const Screen> screens);

/// The place that was kept; none if there is none, or it cannot be read.
std::optional<WindowPlace> readWindowPlace(const std::filesystem::path& file);
/// If nothing can be written, the next window opens at the default place.
void keepWindowPlace(const std::filesystem::path& file, const WindowPlace& place);

}  // namespace hearth
