#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"
#include "load/source.h"
#include "render/renderer.h"
#include "settings/options.h"
#include "viewer/host/screenshots.h"
#include "viewer/host/storage.h"
#include "viewer/host/window_host.h"
#include "viewer/overlay/figures_section.h"
#include "viewer/overlay/marker_space.h"
#include "viewer/walk/automap.h"
#include "viewer/walk/controls.h"
#include "viewer/walk/frame_rate.h"
#include "viewer/walk/walk_panel.h"
#include "viewer/walk/walk_session.h"
#include "viewer/walk/walk_settings.h"
#include "walk/walk_clock.h"

namespace hearth {

/// What a walk runs in.
struct WalkHost {
  WindowHost& window;
  Storage& storage;
  Screenshots& screenshots;
};

/// A walk, round by round: events, the ticks that are due, a picture where it would be another
/// than the last. Waits for nothing but that the window takes the picture, and rests while nothing
/// changes.
class WalkLoop {
 public:
  /// All but the settings must outlive the loop, the scene's level and geometry too. `source`, if
  /// any, is that of the level: without it no places in its files can be copied.
  WalkLoop(const Scene& scene, const Renderer& renderer, WalkSession& session, const WalkHost& host,
           const WalkSettings& settings, std::shared_ptr<const LevelSource> source = nullptr);

  /// From now on these inputs, one for each tick, take the place of the user's; the walk ends with
  /// them. They must outlive the loop.
  void replay(std::span<const WalkInput> inputs) { replay_ = inputs; }
  bool isReplayOver() const { return replay_ && replay_->empty(); }

  /// From now on in another version of the level, where the session has gone on already.
  void goOnIn(const Scene& scene, const Renderer& renderer,
              std::shared_ptr<const LevelSource> source);

  /// The options that have been chosen since the last call, if any. Their owner sees to the rest.
  std::optional<OptionValues> takeChoice();
  void choose(const OptionValues& options);

  /// The lights as they are edited, if they can be. Their owner sees to the rest.
  LightsEditor* lights() { return panel_.lights(); }
  /// From now on the lights of this file, unless there are edits of the one before.
  void editLights(const std::filesystem::path& file);

  /// What stands over the picture until it is given anew: mistakes, a line each, and how far a bake
  /// is.
  void setNotes(std::vector<std::string> mistakes, const std::optional<StageProgress>& bake);

  /// False once the walk is over.
  bool round();

  /// Until the last is written.
  void awaitScreenshots();

 private:
  /// What a picture depends on besides the level.
  struct Frame {
    PictureSize size{};
    Camera camera;  ///< of the picture or, of a channel of geometry, of what the panel leaves of it
    WalkView view;
    std::string message;
    std::vector<std::string> notes;

    friend bool operator==(const Frame&, const Frame&) = default;
  };

  void take(const Event& event);
  void take(WindowEvent event);
  void act(Action action);
  void leave();
  void show(LightMode mode);
  void captureMouse(bool isCaptured);
  void togglePanel();
  void bookmark(const std::string& name);
  void goToNextBookmark();
  void goTo(const Bookmark& bookmark);
  bool canJump() const { return !replay_ && !session_.isKept(); }
  void passTime(double now);
  WalkInput nextInput(int ticksDue);
  void say(std::string message) { say(std::move(message), window_.seconds()); }
  void say(std::string message, double now);
  void updateMessage(double now);
  void updateNotes(double now);
  void tell(const Screenshots::News& news);
  Camera cameraIn(PictureSize picture) const;
  void drawOrRest(double now);
  void draw(double now);
  void drawImage(double now);
  void drawRows(double now);
  void seeWhatIsDrawn();
  void count(double begin, double end);
  bool isCovered() const;
  void drawCaptions();
  void drawPanel(double now);
  PanelSubject panelSubject() const;
  std::optional<MarkerSpace> markerSpace() const;
  void grant(const PanelWishes& wishes, double now);
  void grant(const BookmarkWish& wish);
  void writePreferences();
  std::string cameraText() const;

  Scene scene_;
  const Renderer* renderer_;
  std::shared_ptr<const LevelSource> source_;
  WalkSession& session_;
  WindowHost& window_;
  Storage& storage_;
  Screenshots& screenshots_;
  WalkSettings settings_;
  std::optional<std::span<const WalkInput>> replay_;  ///< what is left of it

  Controls controls_;
  std::size_t nextBookmark_ = 0;
  WalkClock clock_;
  double fractionOfTick_ = 0;  ///< how far the view is from the tick before the last to the last
  bool hasLeft_ = false;

  Frame frame_;  ///< the next picture's
  double messageBegin_ = 0;
  std::optional<double> begin_;     ///< of the walk, in seconds of the clock
  std::vector<std::string> notes_;  ///< of the level and its bake
  bool wantsScreenshot_ = false;
  std::optional<Frame> shown_;  ///< the last picture's; none where it must be drawn again
  double nextFrame_ = 0;        ///< when it may be drawn, in seconds of the clock
  FrameScratch scratch_;
  Image picture_;
  SeenSectors seen_;
  WalkPanel panel_;
  bool capturesMouseAgain_ = false;  ///< once the panel is closed
  Figures figures_;
  Preferences written_;  ///< as the user's file has it
  bool isChoiceNew_ = false;
  bool hasAskedToSave_ = false;
  FrameRate rate_;
  std::string title_;
};

}  // namespace hearth
