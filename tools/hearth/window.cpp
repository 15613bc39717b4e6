#include "hearth/window.h"

#include <SDL.h>

#include <cstdlib>

namespace hearth {

namespace {

constexpr int kWidth = 960;  // pixels, at first; the user may drag it to any size
constexpr int kHeight = 600;

std::string sdlError() { return SDL_GetError(); }

/// The video drivers of the displays that there are. Left to itself, SDL falls back on drivers
/// whose windows nobody sees.
std::string displayDrivers() {
  const bool hasWayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
  const bool hasX11 = std::getenv("DISPLAY") != nullptr;
  if (hasWayland && hasX11) return "wayland,x11";
  if (hasWayland) return "wayland";
  return hasX11 ? "x11" : "";
}

}  // namespace

tl::expected<WalkWindow, std::string> WalkWindow::open(const std::string& title, int pictureWidth,
                                                       int pictureHeight) {
  WalkWindow opened;
  const std::string drivers = displayDrivers();
  if (drivers.empty() && !std::getenv("SDL_VIDEODRIVER"))
    return tl::unexpected<std::string>("neither DISPLAY nor WAYLAND_DISPLAY is set");
  SDL_SetHint(SDL_HINT_VIDEODRIVER, drivers.c_str());  // SDL_VIDEODRIVER still goes before it
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return tl::unexpected(sdlError());
  opened.sdl_ = std::shared_ptr<void>(nullptr, [](void*) { SDL_Quit(); });

  opened.window_ = std::shared_ptr<SDL_Window>(
      SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, kWidth,
                       kHeight, SDL_WINDOW_RESIZABLE),
      [](SDL_Window* window) { SDL_DestroyWindow(window); });
  if (!opened.window_) return tl::unexpected(sdlError());

  SDL_Renderer* renderer = SDL_CreateRenderer(opened.window_.get(), -1, SDL_RENDERER_PRESENTVSYNC);
  if (!renderer) renderer = SDL_CreateRenderer(opened.window_.get(), -1, SDL_RENDERER_SOFTWARE);
  opened.renderer_ = std::shared_ptr<SDL_Renderer>(
      renderer, [](SDL_Renderer* pointer) { SDL_DestroyRenderer(pointer); });
  if (!opened.renderer_) return tl::unexpected(sdlError());
  SDL_RenderSetLogicalSize(renderer, pictureWidth, pictureHeight);

  opened.texture_ = std::shared_ptr<SDL_Texture>(
      SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING, pictureWidth,
                        pictureHeight),
      [](SDL_Texture* texture) { SDL_DestroyTexture(texture); });
  if (!opened.texture_) return tl::unexpected(sdlError());
  return opened;
}

void WalkWindow::setTitle(const std::string& title) {
  SDL_SetWindowTitle(window_.get(), title.c_str());
}

void WalkWindow::show(const Image& image) {
  static_assert(sizeof(Rgb) == 3, "pixels lie as SDL_PIXELFORMAT_RGB24 has them");
  SDL_UpdateTexture(texture_.get(), nullptr, image.pixels().data(), 3 * image.width());
  SDL_RenderClear(renderer_.get());
  SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr);
  SDL_RenderPresent(renderer_.get());
}

void WalkWindow::captureMouse(bool isCaptured) {
  SDL_SetRelativeMouseMode(isCaptured ? SDL_TRUE : SDL_FALSE);
}

}  // namespace hearth
