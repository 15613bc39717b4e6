// Frames of maps of Freedoom against those of dsda-doom, which draws the same place.

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <memory>

#include "desktop/window.h"
#include "peers/child.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr ImageSize kSize{1920, 1080};
/// dsda-doom shows 90 degrees in 4:3, and in wider pictures more at both sides: 2 atan(4/3).
constexpr double kFov = 106.2602047083;

constexpr const char* kDoom = "/usr/games/dsda-doom";
/// The view fills the picture, and nothing lies over it.
constexpr std::string_view kDoomSettings = R"(
screenblocks 11
hud_displayed 0
dsda_hide_weapon 1
show_messages 0
hudadd_demoprogressbar 0
palette_ondamage 0
uncapped_framerate 0
render_wipescreen 0
render_vsync 0
)";

/// In each tic the player turns to the left by so many of 256 parts of a turn: 256 tics are three
/// turns.
constexpr int kTurnsPerTic = 3;
constexpr int kHearthFrames = 256;
constexpr int kDoomTics = 768;
constexpr int kStartTics = 2;  ///< of the demo that shows what starting takes

/// https://doomwiki.org/wiki/Demo: version 1.9, skill 4, one player, no monsters.
std::string demoOfTurning(int mapNumber, int tics) {
  std::string demo{109, 3, 1, static_cast<char>(mapNumber), 0, 0, 0, 1, 0, 1, 0, 0, 0};
  for (int i = 0; i < tics; ++i) demo += {0, 0, static_cast<char>(kTurnsPerTic), 0};
  demo += static_cast<char>(0x80);
  return demo;
}

/// User time of this process, in seconds.
double ownUserSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// dsda-doom with demos of one map.
class Doom {
 public:
  Doom(const std::filesystem::path& folder, const std::string& map)
      : folder_(folder / "doom" / map) {
    create_directories(folder_);
    std::ofstream(folder_ / "settings") << kDoomSettings;
    const int number = std::stoi(map.substr(3));
    for (const int tics : {kStartTics, kDoomTics})
      std::ofstream(folder_ / demoFile(tics), std::ios::binary) << demoOfTurning(number, tics);
  }

  /// User time of a frame.
  tl::expected<double, std::string> milliseconds() const {
    const auto starts = timesOf(playing(kStartTics));
    if (!starts) return tl::unexpected(starts.error());
    return timesOf(playing(kDoomTics)).map([&](const ChildTimes& plays) {
      return 1e3 * (plays.userSeconds - starts->userSeconds) / (kDoomTics - kStartTics);
    });
  }

 private:
  static std::string demoFile(int tics) { return fmt::format("{}.lmp", tics); }

  Child playing(int tics) const {
    return {{kDoom, "-iwad", freedoomWad("MAP"), "-timedemo", demoFile(tics), "-config", "settings",
             "-nosound", "-nomusic", "-window", "-geom",
             fmt::format("{}x{}w", kSize.width, kSize.height)},
            folder_,
            {fmt::format("HOME={}", folder_.string()), "SDL_VIDEODRIVER=dummy",
             "SDL_AUDIODRIVER=dummy"}};
  }

  std::filesystem::path folder_;
};

/// The walk's window on a display that nobody sees.
tl::expected<WalkWindow, std::string> openUnseenWindow() {
  setenv("SDL_VIDEODRIVER", "dummy", 1);
  setenv("SDL_NO_SIGNAL_HANDLERS", "1", 1);  // Ctrl+C ends the program as before
  WindowSettings settings;
  settings.windowSize = kSize;
  settings.waitsForDisplay = false;
  return WalkWindow::open("hearth bench", settings);
}

/// What the player sees turning at the start, drawn and shown as by a walk.
class TurningWalk {
 public:
  TurningWalk(const PeerLevel& level, WalkWindow window)
      : level_(level), window_(std::move(window)) {}

  /// User time of a frame.
  double milliseconds(LightMode mode) {
    drawFrames(1, mode);  // grows the memory
    const double begin = ownUserSeconds();
    drawFrames(kHearthFrames, mode);
    return 1e3 * (ownUserSeconds() - begin) / kHearthFrames;
  }

 private:
  void drawFrames(int frames, LightMode mode) {
    const Player& player = *level_.loaded.level.player;
    for (int i = 0; i < frames; ++i) {
      const double turned = i * (kTurnsPerTic * 360.0 / 256);
      const Camera camera{player.sector, player.eye,  player.angle - turned, 0,
                          kFov,          kSize.width, kSize.height};
      window_.show(kSize, [&](const PixelRows& rows) {
        level_.renderer.draw(camera, mode, scratch_, rows);
      });
    }
  }

  const PeerLevel& level_;
  WalkWindow window_;
  FrameScratch scratch_;
};

Prepared prepareDoomFrame(PeerInputs& inputs, const std::string& map) {
  if (!std::filesystem::exists(kDoom))
    return tl::unexpected<std::string>("dsda-doom is not here: apt-get install dsda-doom");
  const auto level = inputs.freedoomLevel(map);
  if (!level) return tl::unexpected(level.error());
  auto window = openUnseenWindow();
  if (!window) return tl::unexpected(window.error());
  const auto walk = std::make_shared<TurningWalk>(**level, *std::move(window));
  return [doom = Doom(inputs.folder(), map), walk] {
    return doom.milliseconds().map([&](double ofDoom) {
      const double ofHearth = walk->milliseconds(LightMode::Both);
      const double withoutLight = walk->milliseconds(LightMode::None);
      return Figures{ofHearth / ofDoom, ofHearth, ofDoom, withoutLight, ofHearth - withoutLight};
    });
  };
}

}  // namespace

Prepared prepareMap01Frame(PeerInputs& inputs) { return prepareDoomFrame(inputs, "MAP01"); }
Prepared prepareMap15Frame(PeerInputs& inputs) { return prepareDoomFrame(inputs, "MAP15"); }

}  // namespace hearth
