#pragma once

#include <optional>
#include <string>

#include "load/source.h"
#include "render/texture.h"
#include "viewer/inspect/inspect.h"
#include "viewer/inspect/mesh_at.h"
#include "viewer/inspect/sprite_at.h"

namespace hearth {

/// What is asked of the section with the pointer.
struct InspectorRequest {
  std::optional<std::size_t> light = {};   ///< that it is on: an index into the findings
  std::optional<std::size_t> picked = {};  ///< that was clicked on: its index in the level
  bool addsLight = false;                  ///< before the place
  bool letsShine = false;                  ///< all that wears the texture of the place
  bool letsGo = false;                     ///< of what is pinned
  std::optional<std::string> copied = {};
};

/// What belongs to what was found.
struct InspectedSurface {
  const Level& level;
  const Texture& texture;     ///< that the surface wears
  const LevelSource* source;  ///< the way back to the level's files, if there is one
  bool canAddLights;
  std::optional<std::size_t> picked;  ///< the light that is, by its index in the level

  std::string nameOf(std::size_t light) const;
};

/// Writes what was found into the panel. A click on what stands in the level's files copies its
/// place in them, one on the point that itself, a right click on a light its place.
InspectorRequest showInspection(const Inspection& found, const InspectedSurface& surface,
                                bool isPinned);

/// The same of a sprite.
InspectorRequest showSprite(const Level& level, const SpriteHit& found, const BakedLight& light,
                            const LevelSource* source, bool isPinned);

/// The same of a mesh.
InspectorRequest showMesh(const Level& level, const MeshHit& found, const BakedLight& light,
                          const LevelSource* source, bool isPinned);

inline constexpr std::size_t kMaxListedLights = 8;
/// How many of the first lights are listed, and their rays drawn: those whose light comes near.
std::size_t listedLights(const Inspection& found);

}  // namespace hearth
