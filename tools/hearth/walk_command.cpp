#include <SDL.h>
#include <fmt/format.h>

#include <chrono>
#include <string>

#include "hearth/command.h"
#include "hearth/flight.h"
#include "hearth/session.h"
#include "hearth/window.h"
#include "render/renderer.h"

namespace hearth {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double kDegreesPerPixel = 0.15;  // of the mouse
constexpr unsigned kIdleMilliseconds = 8;  // between looks at the keyboard while nothing moves

/// What the user has asked for since the last frame.
struct Input {
  FlightControls controls;
  bool wantsRedraw = false;
  bool wantsQuit = false;
};

/// Turns SDL's events and keys into Input.
class InputReader {
 public:
  InputReader(WalkWindow& window, LightMode& mode) : window_(window), mode_(mode) {}

  Input read() {
    Input input;
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) take(event, input);
    readKeys(input.controls);
    return input;
  }

 private:
  void take(const SDL_Event& event, Input& input) {
    switch (event.type) {
      case SDL_QUIT:
        input.wantsQuit = true;
        break;
      case SDL_WINDOWEVENT:
        input.wantsRedraw = true;
        break;
      case SDL_MOUSEBUTTONDOWN:
        capture(true);
        break;
      case SDL_MOUSEMOTION:
        if (!isCaptured_) break;
        input.controls.turnDegrees += kDegreesPerPixel * event.motion.xrel;
        input.controls.pitchDegrees -= kDegreesPerPixel * event.motion.yrel;
        break;
      case SDL_KEYDOWN:
        takeKey(event.key.keysym.sym, input);
        break;
      default:
        break;
    }
  }

  void takeKey(SDL_Keycode key, Input& input) {
    switch (key) {
      case SDLK_1:
        mode_ = LightMode::Both;
        break;
      case SDLK_2:
        mode_ = LightMode::None;
        break;
      case SDLK_3:
        mode_ = LightMode::Only;
        break;
      case SDLK_ESCAPE:
        if (!isCaptured_) input.wantsQuit = true;
        capture(false);
        break;
      default:
        return;
    }
    input.wantsRedraw = true;
  }

  void capture(bool isCaptured) {
    isCaptured_ = isCaptured;
    window_.captureMouse(isCaptured);
  }

  /// The keys that are held down.
  static void readKeys(FlightControls& controls) {
    const Uint8* keys = SDL_GetKeyboardState(nullptr);
    const auto axis = [keys](SDL_Scancode less, SDL_Scancode less2, SDL_Scancode more,
                             SDL_Scancode more2) {
      return static_cast<double>((keys[more] | keys[more2]) - (keys[less] | keys[less2]));
    };
    controls.forward = axis(SDL_SCANCODE_S, SDL_SCANCODE_DOWN, SDL_SCANCODE_W, SDL_SCANCODE_UP);
    controls.right = axis(SDL_SCANCODE_A, SDL_SCANCODE_A, SDL_SCANCODE_D, SDL_SCANCODE_D);
    controls.up = axis(SDL_SCANCODE_C, SDL_SCANCODE_Q, SDL_SCANCODE_SPACE, SDL_SCANCODE_E);
    controls.turn =
        axis(SDL_SCANCODE_LEFT, SDL_SCANCODE_LEFT, SDL_SCANCODE_RIGHT, SDL_SCANCODE_RIGHT);
    controls.isFast = (keys[SDL_SCANCODE_LSHIFT] | keys[SDL_SCANCODE_RSHIFT]) != 0;
  }

  WalkWindow& window_;
  LightMode& mode_;
  bool isCaptured_ = false;
};

/// The mean time of the frames of the last second, in the window's title.
class FrameClock {
 public:
  FrameClock(WalkWindow& window, std::string name) : window_(window), name_(std::move(name)) {}

  void count(Seconds frame, Clock::time_point now) {
    sum_ += frame;
    ++frames_;
    if (now - shown_ < std::chrono::seconds(1)) return;
    window_.setTitle(fmt::format("{} - {:.1f} ms", name_, 1e3 * sum_.count() / frames_));
    sum_ = Seconds(0);
    frames_ = 0;
    shown_ = now;
  }

 private:
  WalkWindow& window_;
  std::string name_;
  Seconds sum_{0};
  int frames_ = 0;
  Clock::time_point shown_;
};

/// Flies until the user quits.
void fly(WalkWindow& window, const LoadedLevel& loaded, const BakedLight& light, Camera camera,
         LightMode mode) {
  const Renderer renderer(loaded.level, loaded.textures, light);
  InputReader reader(window, mode);
  FrameClock frames(window, loaded.level.name);
  Flight flight{camera.sector, camera.eye, camera.angle, camera.pitch};
  bool isFirst = true;
  Clock::time_point last = Clock::now();
  for (;;) {
    const Input input = reader.read();
    if (input.wantsQuit) return;
    const Clock::time_point now = Clock::now();
    flight = advance(loaded.level, flight, input.controls, Seconds(now - last).count());
    last = now;
    const bool isStill = input.controls == FlightControls{};
    if (isStill && !input.wantsRedraw && !isFirst) {
      SDL_Delay(kIdleMilliseconds);
      continue;
    }
    isFirst = false;
    camera.sector = flight.sector;
    camera.eye = flight.eye;
    camera.angle = flight.angle;
    camera.pitch = flight.pitch;
    const Image image = renderer.draw(camera, mode);
    frames.count(Clock::now() - now, now);
    window.show(image);
  }
}

ExitStatus run(const OptionValues& values) {
  const std::optional<LoadedLevel> loaded = openLevel(values);
  if (!loaded) return ExitStatus::BadInput;
  const auto camera = cameraFor(loaded->level, values, {640, 400});
  if (!camera) return fail(camera.error());
  auto window = WalkWindow::open(fmt::format("{} - baking", loaded->level.name), camera->width,
                                 camera->height);
  if (!window)
    return fail(
        fmt::format("no window can be opened: {}; `hearth shot` needs no display", window.error()));
  const auto light = lightFor(loaded->level, values);
  if (!light) return fail(light.error());
  fly(*window, *loaded, *light, *camera, lightModeFrom(values));
  return ExitStatus::Done;
}

}  // namespace

Command walkCommand() {
  return {"walk",
          "opens a window and flies through the level: W A S D or the arrow keys, E and Q up and "
          "down, Shift faster, a click for the mouse, 1 2 3 for light, Esc to leave",
          std::vector<Option>{Option::Camera, Option::Sector, Option::Shot, Option::Size,
                              Option::Fov, Option::Light, Option::Quiet} +
              lightOptions(),
          {},
          run};
}

}  // namespace hearth
