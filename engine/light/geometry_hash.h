#pragma once

#include <cstdint>
#include <functional>

#include "level/scene.h"

namespace hearth {

class Hash;

/// A number of all that decides which surfaces show, in which order, and where their texels of so
/// many metres lie; the same on every machine. Names, textures except the holes of middle ones,
/// light and the player are no part of it. Nor are ids, which count what shows at other heights
/// alone, too, if it has a texture. saved_bake.md says what it is computed from.
std::uint64_t geometryHash(const Scene& scene, double texel);

/// What stands for the parts of a level that a sector leads to.
struct PartNumbers {
  std::function<std::uint64_t(SectorId)> ofSector;
  std::function<std::uint64_t(FlatPortalId)> ofFlatPortal;
  std::function<std::uint64_t(TextureId)> ofHoles;
};

/// Adds what one sector brings to such a number.
void addGeometry(Hash& hash, const Scene& scene, const Sector& sector, const PartNumbers& numbers);

/// Adds which texels of a masked middle texture are holes; nothing where none is.
void addHoles(Hash& hash, const TexelHoles& holes);

/// Adds all of a light but its sector, for which `sector` stands.
void addLight(Hash& hash, const LightSource& light, std::uint64_t sector);

}  // namespace hearth
