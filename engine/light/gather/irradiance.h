#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "level/level.h"
#include "light/gather/irradiance_map.h"
#include "light/gather/slice.h"

namespace hearth {

/// A texture reflects no more than this, so that light in a closed room ends.
inline constexpr double kMostReflected = 0.95;

/// The light on all surfaces of a level, as others receive it from there: before it is reflected.
class Irradiance {
 public:
  /// `reflectance` multiplies those of the textures. Keeps a reference to the level.
  Irradiance(const Level& level, double reflectance);

  void set(SurfaceId surface, IrradianceMap map) { maps_[surface.index()] = std::move(map); }
  /// Of faces in one plane, by indices into Level::meshFaces.
  void setPatch(std::span<const std::uint32_t> faces, IrradianceMap map);
  /// Of a face on which it is the same everywhere, in levels.
  void setFace(std::uint32_t face, Vec3 levels) { evenFaces_[face] = levels; }

  /// Calls `visit(arc, levels)` for parts of an arc, all of which meets a surface first, with what
  /// it reflects. For the rest see IrradianceMap.
  template <typename Visit>
  void forEachPart(const AreaInSlice& seen, Vec3 from, Vec2 direction, const Arc& arc,
                   double across, Visit&& visit) const {
    const bool isFace = level_[*seen.surface].kind == SurfaceKind::Mesh;
    const Vec3 reflected = reflectanceOf(isFace ? level_.meshFaces[seen.face].texture
                                                : level_[*seen.surface].mapping.texture);
    if (reflected == Vec3{}) return;
    const IrradianceMap* map = isFace ? mapOfFace(seen.face) : mapOf(*seen.surface);
    if (map)
      map->forEachPart(from, direction, arc, across, [&](const Arc& part, Vec3 levels) {
        visit(part, product(reflected, levels));
      });
    else if (isFace && evenFaces_[seen.face] != Vec3{})
      visit(arc, product(reflected, evenFaces_[seen.face]));
  }

 private:
  /// Null where it is dark.
  const IrradianceMap* mapOf(SurfaceId surface) const {
    const std::optional<IrradianceMap>& map = maps_[surface.index()];
    return map && !map->isDark() ? &*map : nullptr;
  }
  const IrradianceMap* mapOfFace(std::uint32_t face) const {
    const std::uint32_t patch = patchOf_[face];
    return patch < patches_.size() && !patches_[patch].isDark() ? &patches_[patch] : nullptr;
  }
  Vec3 reflectanceOf(TextureId texture) const {
    return texture.index() < reflectances_.size() ? reflectances_[texture.index()] : Vec3{};
  }

  const Level& level_;
  std::vector<Vec3> reflectances_;                  ///< by TextureId
  std::vector<std::optional<IrradianceMap>> maps_;  ///< by SurfaceId
  std::vector<IrradianceMap> patches_;
  std::vector<std::uint32_t> patchOf_;  ///< by face; of other faces none
  std::vector<Vec3> evenFaces_;         ///< by face
};

}  // namespace hearth
