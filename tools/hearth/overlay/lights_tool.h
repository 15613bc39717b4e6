#pragma once

#include <SDL_events.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

#include "hearth/edit/lights_editor.h"
#include "hearth/overlay/marker_space.h"
#include "hearth/overlay/pointer.h"
#include "image/image.h"
#include "level/level.h"
#include "load/limits.h"
#include "render/camera.h"

namespace hearth {

/// Lights as they are picked, dragged and marked in a walk's picture.
class LightsTool {
 public:
  LightsTool(std::filesystem::path file, const LoadLimits& limits)
      : editor_(std::move(file), limits) {}

  LightsEditor& editor() { return editor_; }
  const LightsEditor& editor() const { return editor_; }

  /// Picks and drags. Returns whether the event is about a light.
  bool take(const PointerEvent& event, const MarkerSpace& space, int pictureHeight);
  /// Undoes by Ctrl+Z, redoes by Ctrl+Shift+Z or Ctrl+Y, saves by Ctrl+S. Returns whether the event
  /// is one of these, or Ctrl by itself.
  bool take(const SDL_KeyboardEvent& key);
  /// Ends a drag.
  void release();

  /// A mark for each light, dim where `level` hides it from the camera; bright on the map.
  void draw(const Level& level, const Camera& camera, const MarkerSpace& space,
            Image& picture) const;

  /// Puts a light before the eye.
  void addBefore(const Level& level, const Camera& camera);
  /// Whether a light has been picked in the picture, or put there, since the last call.
  bool takePick() { return std::exchange(hasPicked_, false); }

 private:
  std::optional<std::size_t> lightAt(Vec2 pixel, const MarkerSpace& space, int pictureHeight) const;
  void drag(const PointerEvent& event, const MarkerSpace& space);

  /// What is dragged.
  struct Grip {
    LightDescription light;  ///< as it was
    Vec2 toMark;             ///< from the pointer, in pixels
  };

  LightsEditor editor_;
  std::optional<Grip> grip_;
  bool hasPicked_ = false;
};

}  // namespace hearth
