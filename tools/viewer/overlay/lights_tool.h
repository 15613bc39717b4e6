#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "image/pixel_rows.h"
#include "level/scene.h"
#include "load/limits.h"
#include "render/camera.h"
#include "truth/trace.h"
#include "viewer/edit/lights_editor.h"
#include "viewer/input/event.h"
#include "viewer/overlay/collapsible_section.h"
#include "viewer/overlay/marker_space.h"
#include "viewer/overlay/pointer.h"

namespace hearth {

/// Lights as they are picked, dragged and marked in a walk's picture.
class LightsTool {
 public:
  LightsTool(Storage& storage, std::filesystem::path file, const LoadLimits& limits)
      : editor_(storage, std::move(file), limits) {}

  LightsEditor& editor() { return editor_; }
  const LightsEditor& editor() const { return editor_; }
  /// In which lights are edited: called when one is picked outside of it.
  CollapsibleSection& section() { return section_; }

  /// Whether lights have marks, which can be picked.
  bool areMarksShown() const { return areMarksShown_; }
  void showMarks(bool areShown);

  /// Picks and drags. Returns whether the event is about a light.
  bool handle(const PointerEvent& event, const MarkerSpace& space, int pictureHeight);
  /// Undoes by Ctrl+Z, redoes by Ctrl+Shift+Z or Ctrl+Y, saves by Ctrl+S. Returns whether the event
  /// is one of these, or Ctrl by itself, or an axis of a drag.
  bool handle(const KeyEvent& key, const Scene& scene);
  /// Of these Ctrl+S, which no field of text is to keep for itself.
  static bool isSave(const KeyEvent& key);
  /// Ends a drag.
  void release();

  /// What is being dragged, if it has a place.
  struct Drag {
    Vec3 position;
    std::optional<Axis> axis;  ///< along which alone
  };
  std::optional<Drag> drag() const;

  /// A mark for each light: hollow and dim where `scene` hides it from the camera, but on the map.
  /// Suns have theirs where they stand in the sky, and none on the map.
  void draw(const Scene& scene, const Camera& camera, const MarkerSpace& space,
            const PixelRows& picture) const;

  /// Writes the file, unless a light lies where `scene` has no air for it: it could not be opened
  /// again.
  void save(const Scene& scene);

  /// As by a click on its mark. Nothing where there is no such light any more.
  void pick(std::size_t light);
  /// Puts a light before the eye.
  void addBefore(const Scene& scene, const Camera& camera);
  /// Puts a sun where the camera looks, but not near the horizon.
  void addSun(const Camera& camera);
  /// To a file that has none.
  void addSky();
  /// Lets all surfaces shine that wear the texture.
  void addEmitter(const std::string& texture);
  /// Puts a light a metre before a surface, or half as far as there is air.
  void addBefore(const Scene& scene, const SurfacePoint& place);

 private:
  std::optional<std::size_t> lightAt(Vec2 pixel, const MarkerSpace& space, int pictureHeight) const;
  void dragTo(const PointerEvent& event, const MarkerSpace& space);
  void dragSunTo(Vec2 pixel, const MarkerSpace& space);
  void add(const Scene& scene, Vec3 position, std::optional<SectorId> sector);
  void add(const LightDescription& light, const std::string& comment = "");

  /// What holds the light that is dragged.
  struct Grip {
    LightDescription light;  ///< as it was
    Vec2 toMark;             ///< from the pointer, in pixels
    std::optional<Axis> axis = {};
  };

  LightsEditor editor_;
  CollapsibleSection section_;
  bool areMarksShown_ = true;
  std::optional<Grip> grip_;
};

}  // namespace hearth
