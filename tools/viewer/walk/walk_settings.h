#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "model/model_figures.h"
#include "model/orbit_view.h"
#include "render/draw_settings.h"
#include "settings/options.h"
#include "viewer/edit/movers_edit.h"
#include "viewer/overlay/automap.h"
#include "viewer/preferences/bookmarks.h"
#include "viewer/preferences/preferences.h"

namespace hearth {

/// What a picture shows, as keys change it.
struct WalkView {
  LightMode mode = LightMode::Both;
  std::string_view channel = {};  ///< the name of one to show instead; else empty
  bool isMapShown = false;
  double mapMetres = kFirstMapMetres;
  bool areKeysShown = false;

  /// Shows the level itself, in this light.
  void show(LightMode light) {
    mode = light;
    channel = {};
  }

  friend bool operator==(const WalkView&, const WalkView&) = default;
};

/// A model that is turned in place of a walk.
struct TurnedModel {
  ModelFigures figures;
  OrbitView view;  ///< at the start
};

struct WalkSettings {
  std::optional<ImageSize> size = {};  ///< of the picture; without it that of the window
  double fov = 90;                     ///< degrees, horizontal
  double frameCap = 0;                 ///< frames per second; 0: as many as the window takes
  WalkView view = {};
  OptionValues options = {};                             ///< by which the level is lit and drawn
  std::optional<std::filesystem::path> lightsFile = {};  ///< that can be edited
  bool canBake = false;  ///< by others, if the overlay asks for them
  Preferences preferences = {};
  std::filesystem::path config = {};  ///< for the overlay's preferences; empty without one
  Bookmarks bookmarks = {};
  /// Writes a bookmark into the level's file; empty if that is not possible.
  std::function<tl::expected<void, std::string>(const Bookmark&)> writeShot = {};
  /// Writes what is edited of a mover into the level's file, which is then loaded anew; empty if
  /// that is not possible.
  std::function<tl::expected<void, std::string>(const MoverEdit&)> writeMover = {};
  std::vector<std::string> notes = {};    ///< that stand over the picture at first
  std::optional<TurnedModel> model = {};  ///< if the level is one that was made for a model
};

}  // namespace hearth
