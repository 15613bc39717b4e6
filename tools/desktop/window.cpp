#include "desktop/window.h"

#include <SDL.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "desktop/sdl_events.h"

namespace hearth {

namespace {

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

/// The screen without what the desktop keeps for itself. Where it is not told, there is no limit.
ImageSize roomOnScreen() {
  SDL_Rect usable{};
  if (SDL_GetDisplayUsableBounds(0, &usable) != 0) return {kMaxPictureSide, kMaxPictureSide};
  return {std::max(1, usable.w), std::max(1, usable.h)};
}

/// How often a size goes into another, whole, both ways.
int timesIn(ImageSize room, ImageSize size) {
  return std::min(room.width / size.width, room.height / size.height);
}

/// In its shape, as large as there is room for it.
ImageSize shrunk(ImageSize size, ImageSize room) {
  if (timesIn(room, size) > 0) return size;
  const double fraction = std::min(static_cast<double>(room.width) / size.width,
                                   static_cast<double>(room.height) / size.height);
  const auto side = [fraction](int whole) {
    return std::max(1, static_cast<int>(std::lround(fraction * whole)));
  };
  return {side(size.width), side(size.height)};
}

/// A picture of a size of its own gets a window of a whole number of times that size. No window is
/// larger than the screen.
ImageSize firstSize(const std::optional<ImageSize>& picture) {
  const ImageSize room = roomOnScreen();
  const ImageSize usual = shrunk(kFirstWindowSize, room);
  if (!picture) return usual;
  const int times = std::max(1, timesIn(usual, *picture));
  return shrunk({times * picture->width, times * picture->height}, room);
}

std::vector<Screen> screens() {
  std::vector<Screen> screens;
  for (int i = 0; i < SDL_GetNumVideoDisplays(); ++i)
    if (SDL_Rect usable{};
        SDL_GetDisplayUsableBounds(i, &usable) == 0 && usable.w > 0 && usable.h > 0)
      screens.push_back({usable.x, usable.y, usable.w, usable.h});
  return screens;
}

PixelRows rowsOf(void* pixels, int bytesPerRow, ImageSize size) {
  return {static_cast<Uint32*>(pixels), static_cast<std::size_t>(bytesPerRow) / sizeof(Uint32),
          size.width, size.height};
}

}  // namespace

tl::expected<WalkWindow, std::string> WalkWindow::open(const std::string& title,
                                                       const WindowSettings& settings) {
  WalkWindow opened(settings);
  const auto created = opened.create(title);
  if (!created) return tl::unexpected(created.error());
  return opened;
}

tl::expected<void, std::string> WalkWindow::create(const std::string& title) {
  const std::string drivers = displayDrivers();
  if (drivers.empty() && !std::getenv("SDL_VIDEODRIVER"))
    return tl::unexpected<std::string>("neither DISPLAY nor WAYLAND_DISPLAY is set");
  SDL_SetHint(SDL_HINT_VIDEODRIVER, drivers.c_str());  // SDL_VIDEODRIVER still goes before it
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return tl::unexpected(sdlError());
  sdl_ = std::shared_ptr<void>(nullptr, [](void*) { SDL_Quit(); });
  SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);  // one walks without gamepads, too

  WindowPlace place{SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, {}};
  if (settings_.place)
    place = onScreen(*settings_.place, screens());
  else
    place.size = settings_.windowSize ? *settings_.windowSize : firstSize(settings_.pictureSize);
  window_ = std::shared_ptr<SDL_Window>(
      SDL_CreateWindow(title.c_str(), place.x, place.y, place.size.width, place.size.height,
                       SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI),
      [](SDL_Window* window) { SDL_DestroyWindow(window); });
  if (!window_) return tl::unexpected(sdlError());
  auto created = createRenderer();
  if (created && place.isFullScreen) toggleFullScreen();
  return created;
}

tl::expected<void, std::string> WalkWindow::createRenderer() {
  const Uint32 flags = settings_.waitsForDisplay ? SDL_RENDERER_PRESENTVSYNC : 0;
  SDL_Renderer* renderer = SDL_CreateRenderer(window_.get(), -1, flags);
  if (!renderer) renderer = SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE);
  renderer_ = std::shared_ptr<SDL_Renderer>(
      renderer, [](SDL_Renderer* pointer) { SDL_DestroyRenderer(pointer); });
  if (!renderer_) return tl::unexpected(sdlError());

  SDL_RendererInfo info{};
  SDL_GetRendererInfo(renderer, &info);
  drawsOnSurface_ = (info.flags & SDL_RENDERER_SOFTWARE) != 0;
  if (info.max_texture_width > 0) largest_.width = std::min(largest_.width, info.max_texture_width);
  if (info.max_texture_height > 0)
    largest_.height = std::min(largest_.height, info.max_texture_height);
  const std::optional<ImageSize> size = settings_.pictureSize;
  if (size && (size->width > largest_.width || size->height > largest_.height))
    return tl::unexpected(fmt::format("this display shows pictures of at most {}x{}",
                                      largest_.width, largest_.height));
  return {};
}

double WalkWindow::seconds() {
  return static_cast<double>(SDL_GetPerformanceCounter()) /
         static_cast<double>(SDL_GetPerformanceFrequency());
}

std::optional<Event> WalkWindow::poll() {
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
    prepare(event);
    if (auto own = eventFrom(event)) return own;
  }
  return std::nullopt;
}

void WalkWindow::prepare(SDL_Event& event) {
  if (event.type == SDL_CONTROLLERDEVICEADDED || event.type == SDL_CONTROLLERDEVICEREMOVED)
    setGamepad(event.cdevice);
  if (event.type == SDL_MOUSEMOTION) moveIntoPicture(event.motion.x, event.motion.y);
  if (event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP)
    moveIntoPicture(event.button.x, event.button.y);
}

/// From the desktop's points, of which there are fewer than pixels on displays of high density.
void WalkWindow::moveIntoPicture(int& x, int& y) const {
  ImageSize points{};
  ImageSize pixels{};
  SDL_GetWindowSize(window_.get(), &points.width, &points.height);
  if (!shown_ || points.width < 1 || points.height < 1 ||
      SDL_GetRendererOutputSize(renderer_.get(), &pixels.width, &pixels.height) != 0)
    return;
  const auto& [place, picture] = *shown_;
  x = pixelAt((x + 0.5) * pixels.width / points.width, place.x, place.width, picture.width);
  y = pixelAt((y + 0.5) * pixels.height / points.height, place.y, place.height, picture.height);
}

/// Gamepads report only while they are open.
void WalkWindow::setGamepad(const SDL_ControllerDeviceEvent& event) {
  if (event.type == SDL_CONTROLLERDEVICEREMOVED) {
    gamepads_.erase(event.which);
    return;
  }
  SDL_GameController* gamepad = SDL_GameControllerOpen(event.which);
  if (!gamepad) return;
  const SDL_JoystickID id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(gamepad));
  gamepads_[id] = std::shared_ptr<SDL_GameController>(
      gamepad, [](SDL_GameController* pointer) { SDL_GameControllerClose(pointer); });
}

void WalkWindow::rest(double seconds) {
  const auto milliseconds = static_cast<int>(std::lround(1e3 * seconds));
  SDL_WaitEventTimeout(nullptr, std::max(1, milliseconds));
}

std::optional<ImageSize> WalkWindow::windowSize() {
  constexpr Uint32 kUnseen = SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN;
  ImageSize size{};
  if ((SDL_GetWindowFlags(window_.get()) & kUnseen) != 0 ||
      SDL_GetRendererOutputSize(renderer_.get(), &size.width, &size.height) != 0)
    return std::nullopt;
  return ImageSize{std::clamp(size.width, 1, largest_.width),
                   std::clamp(size.height, 1, largest_.height)};
}

void WalkWindow::show(ImageSize size, const DrawRows& draw) {
  const std::optional<ImageSize> window = windowSize();
  if (!window) return;
  shown_ = {placed(size, *window, settings_.scaling), size};
  if (SDL_Surface* const surface = surfaceOfSize(size)) {
    draw(rowsOf(surface->pixels, surface->pitch, size));
    SDL_UpdateWindowSurface(window_.get());
    return;
  }
  fitTexture(size);
  void* pixels = nullptr;
  int bytesPerRow = 0;
  if (!texture_ || SDL_LockTexture(texture_.get(), nullptr, &pixels, &bytesPerRow) != 0) return;
  draw(rowsOf(pixels, bytesPerRow, size));
  SDL_UnlockTexture(texture_.get());
  present(*window);
}

/// That of the window, if a picture of this size can be drawn on it: it would be copied there.
SDL_Surface* WalkWindow::surfaceOfSize(ImageSize size) const {
  SDL_Surface* const surface = drawsOnSurface_ ? SDL_GetWindowSurface(window_.get()) : nullptr;
  if (!surface || SDL_MUSTLOCK(surface)) return nullptr;
  const bool fits = surface->format->format == SDL_PIXELFORMAT_RGB888 && surface->w == size.width &&
                    surface->h == size.height;
  return fits ? surface : nullptr;
}

void WalkWindow::present(ImageSize window) {
  const Placement& place = shown_->place;
  SDL_SetTextureScaleMode(texture_.get(),
                          place.hasSquarePixels ? SDL_ScaleModeNearest : SDL_ScaleModeLinear);
  const SDL_Rect target{place.x, place.y, place.width, place.height};
  if (place.width != window.width || place.height != window.height)
    SDL_RenderClear(renderer_.get());
  SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, &target);
  SDL_RenderPresent(renderer_.get());
}

/// Its pixels lie as PixelRows has them, which renderers take as they are.
void WalkWindow::fitTexture(ImageSize size) {
  if (texture_ && textureSize_ == size) return;
  texture_ = std::shared_ptr<SDL_Texture>(
      SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB888, SDL_TEXTUREACCESS_STREAMING,
                        size.width, size.height),
      [](SDL_Texture* texture) { SDL_DestroyTexture(texture); });
  textureSize_ = size;
}

void WalkWindow::setTitle(const std::string& title) {
  SDL_SetWindowTitle(window_.get(), title.c_str());
}

void WalkWindow::captureMouse(bool isCaptured) {
  SDL_SetRelativeMouseMode(isCaptured ? SDL_TRUE : SDL_FALSE);
}

bool WalkWindow::isFullScreen() const {
  return (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
}

void WalkWindow::toggleFullScreen() {
  if (!isFullScreen()) {
    unfilled_ = placeNow();
    SDL_SetWindowFullscreen(window_.get(), SDL_WINDOW_FULLSCREEN_DESKTOP);
    return;
  }
  SDL_SetWindowFullscreen(window_.get(), 0);
  // Where nobody manages windows they do not go back by themselves.
  SDL_SetWindowSize(window_.get(), unfilled_.size.width, unfilled_.size.height);
  SDL_SetWindowPosition(window_.get(), unfilled_.x, unfilled_.y);
}

WindowPlace WalkWindow::placeNow() const {
  WindowPlace place;
  SDL_GetWindowPosition(window_.get(), &place.x, &place.y);
  SDL_GetWindowSize(window_.get(), &place.size.width, &place.size.height);
  return place;
}

WindowPlace WalkWindow::place() const {
  WindowPlace place = isFullScreen() ? unfilled_ : placeNow();
  place.isFullScreen = isFullScreen();
  return place;
}

void WalkWindow::answerDesktop() {
  constexpr Uint32 kMilliseconds = 5;
  SDL_PumpEvents();
  SDL_Delay(kMilliseconds);
}

void WalkWindow::copy(const std::string& text) { ::SDL_SetClipboardText(text.data()); }

/// By proc(5).
double WalkWindow::residentBytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0;
  double resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

void WalkWindow::print(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace hearth
