#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "image/image.h"

struct SDL_Renderer;
struct SDL_Texture;
struct SDL_Window;

namespace hearth {

/// A window that shows pictures of one size, scaled to fit.
class WalkWindow {
 public:
  /// Errors are SDL's sentence: there may be no display.
  static tl::expected<WalkWindow, std::string> open(const std::string& title, int pictureWidth,
                                                    int pictureHeight);

  void setTitle(const std::string& title);
  /// `image` has the size that the window was opened for.
  void show(const Image& image);
  /// Hides the mouse pointer and reports the mouse's motion without end.
  void captureMouse(bool isCaptured);

 private:
  WalkWindow() = default;

  // Destroyed in reverse order: SDL itself last.
  std::shared_ptr<void> sdl_;
  std::shared_ptr<SDL_Window> window_;
  std::shared_ptr<SDL_Renderer> renderer_;
  std::shared_ptr<SDL_Texture> texture_;
};

}  // namespace hearth
