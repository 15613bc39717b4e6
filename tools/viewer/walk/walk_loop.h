#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "load/source.h"
#include "model/model_figures.h"
#include "render/renderer.h"
#include "settings/options.h"
#include "viewer/host/walk_host.h"
#include "viewer/orbit/orbit.h"
#include "viewer/orbit/orbit_controls.h"
#include "viewer/overlay/marker_space.h"
#include "viewer/preferences/config.h"
#include "viewer/walk/controls.h"
#include "viewer/walk/moved_view.h"
#include "viewer/walk/notices.h"
#include "viewer/walk/walk_bookmarks.h"
#include "viewer/walk/walk_frame.h"
#include "viewer/walk/walk_panel.h"
#include "viewer/walk/walk_screen.h"
#include "viewer/walk/walk_session.h"
#include "viewer/walk/walk_settings.h"
#include "walk/walk_clock.h"

namespace hearth {

/// A walk, round by round: events, the ticks that are due, and a picture if it differs from the
/// last. It waits only for the window to take the picture, and rests while nothing changes. With a
/// model in its settings it turns that model, and does not walk.
class WalkLoop {
 public:
  /// All arguments except the settings must outlive the loop, the scene's level and geometry too.
  /// `scene` is the level as authored, and `renderer` draws it so. `source`, if any, is that of
  /// the level; without it no places in its files can be copied.
  WalkLoop(const Scene& scene, const Renderer& renderer, WalkSession& session, const WalkHost& host,
           const WalkSettings& settings, std::shared_ptr<const LevelSource> source = nullptr);
  WalkLoop(const WalkLoop&) = delete;
  WalkLoop& operator=(const WalkLoop&) = delete;

  /// From now on these inputs, one for each tick, replace the user's. The walk ends with them. They
  /// must outlive the loop.
  void replay(std::span<const WalkInput> inputs);
  bool isReplayOver() const { return replay_ && replay_->empty(); }

  /// Goes on in another version of the level, where the session already is.
  void continueIn(const Scene& scene, const Renderer& renderer,
                  std::shared_ptr<const LevelSource> source);

  /// Goes on with another version of the model, after `continueIn` with its level.
  void continueWith(const ModelFigures& model);

  /// The options that were chosen since the last call, if any. The caller applies them.
  std::optional<OptionValues> takeChoice();
  void choose(const OptionValues& options);

  /// The edited lights, if they can be edited. The caller bakes them.
  LightsEditor* lightsEditor() { return panel_.lightsEditor(); }
  /// From now on edits the lights of this file, unless there are edits of the one before.
  void editLights(const std::filesystem::path& file);

  /// Sets the notes over the picture, which stand until the next call: mistakes, a line each, and
  /// the progress of a bake.
  void setNotes(std::vector<std::string> mistakes, const std::optional<StageProgress>& bake);

  /// The states at rest of the level's movers, by share of each, whose light would show and is not
  /// known; the first is needed most.
  std::span<const std::vector<double>> wantedLight() const;
  /// Adds the light of one. The level has the same movers.
  void addLight(std::shared_ptr<const RestLight> rest);

  /// False once the walk is over.
  bool round();

  /// Waits until the last screenshot is written.
  void awaitScreenshots();

 private:
  void handle(const Event& event);
  void handle(WindowEvent event);
  void act(Action action);
  void leave();
  void captureMouse(bool isCaptured);
  void togglePanel();
  void passTime(double now);
  void tickModel(int ticksDue);
  void goHome();
  Eye eyeOfFrame(double bob) const;
  WalkInput nextInput(int ticksDue);
  void say(std::string message) { notices_.say(std::move(message), window_.seconds()); }
  void updateNotices(double now);
  void moveFlats();
  void aimCamera();
  PanelSubject panelSubject() const;
  void grant(const PanelRequests& requests);
  void write(const MoverEdit& edit);

  std::unique_ptr<MovedView> moved_;  ///< where the level has movers
  Scene scene_;                       ///< as frames show it
  std::shared_ptr<const LevelSource> source_;
  WalkSession& session_;
  WindowHost& window_;
  Storage& storage_;
  Screenshots& screenshots_;
  Workers* workers_;
  WalkSettings settings_;
  ConfigFile config_;
  std::optional<std::span<const WalkInput>> replay_;  ///< what is left of it

  /// A model that is turned: its camera moves in place of the session's walker.
  struct ModelTurn {
    ModelFigures figures;
    Orbit orbit;
    OrbitControls controls = {};
  };
  std::optional<ModelTurn> model_;

  Controls controls_;
  WalkBookmarks bookmarks_;
  WalkClock clock_;
  double fractionOfTick_ = 0;  ///< how far the view is from the tick before the last to the last
  bool hasLeft_ = false;

  Notices notices_;
  WalkFrame frame_;  ///< the next one
  WalkScreen screen_;
  WalkPanel panel_;
  bool capturesMouseAgain_ = false;  ///< once the panel is closed
  bool isChoiceNew_ = false;
  bool hasAskedToSave_ = false;
};

}  // namespace hearth
