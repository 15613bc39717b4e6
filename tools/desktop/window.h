#pragma once

#include <SDL_events.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "desktop/window_place.h"
#include "viewer/host/window_host.h"
#include "viewer/walk/placement.h"

struct SDL_Renderer;
struct SDL_Surface;
struct SDL_Texture;
struct SDL_Window;

namespace hearth {

/// The first size and place of a window, as far as picture and screen allow. The user may drag it
/// to any other.
inline constexpr ImageSize kFirstWindowSize = {960, 600};

struct WindowSettings {
  std::optional<ImageSize> pictureSize;  ///< without it, pictures come in the window's size
  std::optional<ImageSize> windowSize;   ///< without it, one that fits picture and screen
  std::optional<WindowPlace> place;      ///< in place of both, as far as the screen has room
  Scaling scaling = Scaling::Smooth;
  bool waitsForDisplay = true;  ///< vertical sync
};

/// A window on the user's desktop, with keyboard, mouse and gamepads.
class WalkWindow : public WindowHost {
 public:
  /// Errors are one sentence: there may be no display, or it cannot show so large a picture.
  static tl::expected<WalkWindow, std::string> open(const std::string& title,
                                                    const WindowSettings& settings);

  double seconds() override;
  std::optional<Event> poll() override;
  void rest(double seconds) override;
  std::optional<ImageSize> windowSize() override;
  void show(ImageSize size, const DrawRows& draw) override;
  void setTitle(const std::string& title) override;
  void captureMouse(bool isCaptured) override;
  void toggleFullScreen() override;
  void copy(const std::string& text) override;
  double residentBytes() override;
  void print(const std::string& line) override;

  /// Answers the desktop, and rests a little. Desktops call a program that does not answer hung.
  static void answerDesktop();

  /// Where it lies, to open the next window there.
  WindowPlace place() const;

 private:
  explicit WalkWindow(const WindowSettings& settings) : settings_(settings) {}
  tl::expected<void, std::string> create(const std::string& title);
  tl::expected<void, std::string> createRenderer();
  bool isFullScreen() const;
  WindowPlace placeNow() const;
  void prepare(SDL_Event& event);
  void setGamepad(const SDL_ControllerDeviceEvent& event);
  SDL_Surface* surfaceOfSize(ImageSize size) const;
  void fitTexture(ImageSize size);
  void present(ImageSize window);
  void moveIntoPicture(int& x, int& y) const;

  WindowSettings settings_;
  ImageSize largest_{kMaxPictureSide, kMaxPictureSide};  ///< that the display can show
  bool drawsOnSurface_ = false;  ///< the renderer, without the help of hardware
  std::optional<ImageSize> textureSize_;
  struct Shown {
    Placement place;
    ImageSize picture;
  };
  std::optional<Shown> shown_;  ///< the last picture
  WindowPlace unfilled_;        ///< to which it goes back from the full screen

  // Destroyed in reverse order: SDL itself last.
  std::shared_ptr<void> sdl_;
  std::shared_ptr<SDL_Window> window_;
  std::shared_ptr<SDL_Renderer> renderer_;
  std::shared_ptr<SDL_Texture> texture_;
  std::map<SDL_JoystickID, std::shared_ptr<SDL_GameController>> gamepads_;
};

}  // namespace hearth
