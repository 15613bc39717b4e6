#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// The lights of a scene that are areas: its sky, surfaces that shine, and light that bounces. Each
/// has a place among them.
class AreaLights {
 public:
  using Place = std::uint32_t;

  explicit AreaLights(const Scene& scene);

  /// Indices of these among the lights of the scene, rising.
  const std::vector<std::size_t>& lights() const { return lights_; }
  Place placeOf(std::size_t light) const {
    return static_cast<Place>(std::ranges::lower_bound(lights_, light) - lights_.begin());
  }

  std::optional<Place> sky() const { return sky_; }
  /// What surfaces shine with that wear a texture; none if they do not.
  std::optional<Place> ofTexture(TextureId texture) const { return ofTextures_[texture.index()]; }
  /// The first of those that bounce; they are the last.
  std::optional<Place> bounced() const { return bounced_; }
  /// Whether any surfaces can shine.
  bool haveEmitters() const { return haveEmitters_; }
  /// Whether any faces of meshes do.
  bool haveShiningFaces() const { return haveShiningFaces_; }
  /// Whether any light comes from surfaces, ...
  bool needSurfaces() const { return haveEmitters_ || bounced_; }
  /// ... or from faces of meshes.
  bool needFaces() const { return haveShiningFaces_ || bounced_; }

 private:
  std::vector<std::size_t> lights_;
  std::optional<Place> sky_;
  std::vector<std::optional<Place>> ofTextures_;  ///< by TextureId
  std::optional<Place> bounced_;
  bool haveEmitters_ = false;
  bool haveShiningFaces_ = false;
};

}  // namespace hearth
