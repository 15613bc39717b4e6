#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "level/scene.h"

namespace hearth {

class AreaLights;
class Hash;

/// A hash of all that decides which surfaces show, in which order, and where their texels lie,
/// which are `texel` metres wide, of where meshes are, and of the points of air whose light sprites
/// take; the same on every machine. It leaves out names, light, the player, and textures except the
/// holes of masked ones. It also leaves out ids, which count surfaces that show only at other
/// heights. saved_bake.md lists its input.
std::uint64_t geometryHash(const Scene& scene, double texel);

/// The numbers that stand for the parts of a level to which a sector leads.
struct PartNumbers {
  std::function<std::uint64_t(SectorId)> ofSector;
  std::function<std::uint64_t(FlatPortalId)> ofFlatPortal;
  std::function<std::uint64_t(TextureId)> ofHoles;
};

/// Adds one sector to such a hash.
void addGeometry(Hash& hash, const Scene& scene, const Sector& sector, const PartNumbers& numbers);

/// Adds where the faces of a mesh are, and what they do to light.
void addMesh(Hash& hash, const Level& level, const Mesh& mesh);

/// By sector, a hash of which of its surfaces shine, each by the name of its texture; empty where
/// no surfaces of the level can.
std::vector<std::uint64_t> hashesOfShining(const Level& level, const AreaLights& lights);
/// Adds which faces of a mesh shine, in the same way; nothing where none of the level can.
void addShining(Hash& hash, const Level& level, const AreaLights& lights, const Mesh& mesh);

/// Adds what each surface and face reflects.
void addReflectances(Hash& hash, const Level& level);

/// Adds which texels of a masked middle texture are holes; nothing where none is.
void addHoles(Hash& hash, const TexelHoles& holes);

/// Adds a light. `sector` stands for its sector, if it has one.
void addLight(Hash& hash, const LightSource& light, std::uint64_t sector);

}  // namespace hearth
