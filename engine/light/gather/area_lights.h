#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "level/level.h"

namespace hearth {

/// The lights of a level that are areas: its sky, and surfaces that shine. Each has a place among
/// them.
class AreaLights {
 public:
  using Place = std::uint32_t;

  explicit AreaLights(const Level& level);

  /// Indices of these among the lights of the level, rising.
  const std::vector<std::size_t>& lights() const { return lights_; }
  Place placeOf(std::size_t light) const {
    return static_cast<Place>(std::ranges::lower_bound(lights_, light) - lights_.begin());
  }

  std::optional<Place> sky() const { return sky_; }
  /// What surfaces shine with that wear a texture; none if they do not.
  std::optional<Place> ofTexture(TextureId texture) const { return ofTextures_[texture.index()]; }
  /// Whether any surfaces can shine.
  bool haveSurfaces() const { return haveSurfaces_; }
  /// Whether any faces of meshes do.
  bool haveFaces() const { return haveFaces_; }

 private:
  std::vector<std::size_t> lights_;
  std::optional<Place> sky_;
  std::vector<std::optional<Place>> ofTextures_;  ///< by TextureId
  bool haveSurfaces_ = false;
  bool haveFaces_ = false;
};

}  // namespace hearth
