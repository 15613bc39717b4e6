#pragma once

#include <string>
#include <vector>

#include "level/level.h"
#include "render/camera.h"
#include "render/draw_settings.h"
#include "settings/options.h"
#include "viewer/walk/walk_settings.h"
#include "walk/walker.h"

namespace hearth {

/// All that a picture of a walk depends on, besides the level.
struct WalkFrame {
  ImageSize size{};
  Camera camera;  ///< of the picture; for a channel of geometry, of its part beside the panel
  Eye eye;        ///< without head bob: the middle of the map
  std::vector<double> shares;  ///< of the level's movers
  WalkView view;
  std::string message;
  std::vector<std::string> notes;

  friend bool operator==(const WalkFrame&, const WalkFrame&) = default;
};

/// The options with which `hearth shot` draws what the camera sees of a level.
std::string shotOptionsOf(const WalkFrame& frame, const Level& level, const DrawSettings& settings);

}  // namespace hearth
