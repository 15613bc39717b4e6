#pragma once

#include <optional>
#include <string>

#include "load/source.h"
#include "render/renderer.h"
#include "viewer/input/event.h"
#include "viewer/inspect/inspect.h"
#include "viewer/inspect/mesh_at.h"
#include "viewer/inspect/sprite_at.h"
#include "viewer/overlay/collapsible_section.h"
#include "viewer/overlay/lights_tool.h"

namespace hearth {

/// A level as it is walked in.
struct InspectedLevel {
  Scene scene;
  const Renderer& renderer;
  const BakeSettings& settings;  ///< of its bake
  const LevelSource* source;     ///< the way back to its files, if there is one
  LightsTool* lights = nullptr;  ///< to pick and add lights, where they can be edited
  bool isInPicture = true;       ///< as the camera sees it; else there is nowhere for rays
};

/// A section of the overlay: what the pointer is at in the picture, and why it is as light as it
/// is. A click pins the place, and opens the section.
class Inspector {
 public:
  /// Positions are in pixels of the picture, of whose width `width` are left of the panel.
  void handle(const Event& event, int width);

  /// Lets go of what is pinned. Returns whether anything was.
  bool letGo();

  /// From now on the level is another, or lit otherwise. What is pinned is looked at anew.
  void forget() {
    found_.reset();
    sprite_.reset();
    mesh_.reset();
  }

  /// What the section shows; none where it is closed, or the pointer at nothing or at a thing.
  const std::optional<Inspection>& found() const { return found_; }

  /// `camera` is that of the picture. Returns what is to be copied.
  std::optional<std::string> show(const InspectedLevel& in, const Camera& camera);

 private:
  /// A look at a place, which finds the same place again in another version of the level.
  struct Look {
    std::string sector;  ///< of the eye
    Vec3 eye;
    Vec3 direction;
    Vec2 pictureRight;

    friend bool operator==(const Look&, const Look&) = default;
  };
  struct Pixel {
    int x;
    int y;
  };

  Look lookThrough(Pixel pixel, const InspectedLevel& in, const Camera& camera) const;
  void find(const Look& look, const InspectedLevel& in);
  bool isThingFound() const { return sprite_ || mesh_; }

  std::optional<Pixel> mouse_;  ///< while it is over the picture
  bool isClicked_ = false;      ///< since it was shown last
  CollapsibleSection section_;
  std::optional<Look> pinned_;
  std::optional<Look> look_;  ///< by which the last was found
  std::optional<Inspection> found_;
  std::optional<SpriteHit> sprite_;  ///< found in place of a surface
  std::optional<MeshHit> mesh_;      ///< likewise
};

}  // namespace hearth
