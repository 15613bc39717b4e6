#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/pixel_rows.h"
#include "load/limits.h"
#include "load/source.h"
#include "model/model_figures.h"
#include "render/renderer.h"
#include "viewer/edit/lights_editor.h"
#include "viewer/input/event.h"
#include "viewer/overlay/bookmarks_section.h"
#include "viewer/overlay/figures_section.h"
#include "viewer/overlay/inspector.h"
#include "viewer/overlay/lights_tool.h"
#include "viewer/overlay/marker_space.h"
#include "viewer/overlay/movers_section.h"
#include "viewer/overlay/overlay.h"
#include "viewer/overlay/pointer.h"
#include "viewer/overlay/preferences_section.h"
#include "viewer/overlay/tab_bar.h"
#include "viewer/walk/walk_settings.h"

namespace hearth {

/// The subject of the panel, and the picture that it lies over.
struct PanelSubject {
  Scene scene;
  const Renderer& renderer;
  const LevelSource* source;  ///< the way back to the level's files, if there is one
  const Camera& camera;
  ImageSize size;                    ///< of the picture, the panel included
  std::optional<MarkerSpace> space;  ///< where lights can be marked, if anywhere
  bool isLevelShown;                 ///< as the camera sees it, rather than a map or a drawing
  BookmarkPermissions bookmarks;
  std::span<const double> moverShares;  ///< where the scene's movers stand
  MoverPermissions movers;
  const ModelFigures* model;  ///< if it is a model that is turned
};

/// Requests from the panel that only the walk can grant.
struct PanelRequests {
  bool optionsChanged = false;             ///< those of the settings
  bool preferencesChanged = false;         ///< and can be written
  std::optional<std::string> copied = {};  ///< for the clipboard
  std::optional<BookmarkRequest> bookmark = {};
  std::optional<MoverEdit> mover = {};  ///< to be written
};

/// The overlay of a walk, with its tabs, and what the mouse does in the picture beside it.
class WalkPanel {
 public:
  /// `bake`: the settings of the level's light.
  explicit WalkPanel(const BakeSettings& bake) : bake_(bake) {}

  bool isOpen() const { return overlay_.isOpen(); }
  void toggle();
  bool isStale(double now) const { return overlay_.isStale(now); }
  /// The pixels of a picture's width to the left of it.
  int widthBeside(int pictureWidth) const { return overlay_.widthBeside(pictureWidth); }

  /// Returns whether the event was for the panel alone. Keys are chosen in `preferences`.
  bool handle(const Event& event, const PanelSubject& subject, Preferences& preferences);
  /// Releases what the mouse holds.
  void releasePointer();
  /// Lets go of the place that is inspected. Returns whether there was one.
  bool letGo() { return isOpen() && inspector_.letGo(); }
  /// Call it when the level or its light has changed.
  void forget();

  /// The mover that is dragged, and where to.
  const std::optional<MoverShare>& heldMover() const { return moversSection_.held(); }
  /// What was requested of a mover has been written.
  void noteWritten(const MoverEdit& edit) { moversSection_.noteWritten(edit); }

  /// The edited lights, if they can be edited.
  LightsEditor* lightsEditor() { return lightsTool_ ? &lightsTool_->editor() : nullptr; }
  /// From now on edits the lights of this file, unless there are edits of the one before.
  void editLights(Storage& storage, const std::filesystem::path& file, const LoadLimits& limits);
  /// Whether closing the walk would lose edits.
  bool hasUnsavedLights() { return lightsTool_ && lightsEditor()->isUnsaved(); }

  /// Marks the lights while the panel is open.
  void drawMarks(const PanelSubject& subject, const PixelRows& picture) const;
  /// Draws the panel, if it is open, and changes the settings and the view by what is chosen in it.
  /// `now` in seconds.
  PanelRequests draw(double now, const PanelSubject& subject, const Figures& figures,
                     WalkSettings& settings, WalkView& view, const PixelRows& picture);

 private:
  void handlePointer(const Event& event, const PanelSubject& subject);
  std::vector<Tab> tabsFor(const PanelSubject& subject, const Figures& figures,
                           WalkSettings& settings, WalkView& view, PanelRequests& requests);
  std::optional<std::string> showLightTab(const PanelSubject& subject);
  bool showQualityTab(const PanelSubject& subject, WalkSettings& settings);

  Overlay overlay_;
  TabBar tabs_;
  Inspector inspector_;
  Pointer pointer_;
  std::optional<LightsTool> lightsTool_;
  PreferencesSection preferencesSection_;
  BookmarksSection bookmarksSection_;
  MoversSection moversSection_;
  BakeSettings bake_;  ///< of the level at hand, by the options
};

}  // namespace hearth
