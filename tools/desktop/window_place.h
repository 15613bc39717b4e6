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
  PictureSize size{};
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

/// No larger than the screen on which most of it lies, and wholly on that. On which none of it
/// lies, as when a screen has gone, it is moved to the first. Without screens it stays as it is.
WindowPlace onScreen(WindowPlace place, std::span<const Screen> screens);

/// As it was kept; nothing where it was not, or can no longer be read.
std::optional<WindowPlace> readWindowPlace(const std::filesystem::path& file);
/// Does its best: where nothing can be written the next window lies where all do at first.
void keepWindowPlace(const std::filesystem::path& file, const WindowPlace& place);

}  // namespace hearth
