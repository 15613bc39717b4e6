#pragma once

#include <optional>
#include <string>

#include "hearth/inspect/inspect.h"
#include "load/source.h"
#include "render/texture.h"

namespace hearth {

/// What is asked of the section with the pointer.
struct InspectorRequest {
  std::optional<std::size_t> light = {};  ///< that it is on: an index into the findings
  bool letsGo = false;                    ///< of what is pinned
  std::optional<std::string> copied = {};
};

/// What belongs to what was found.
struct InspectedSurface {
  const Level& level;
  const Texture& texture;     ///< that the surface wears
  const LevelSource* source;  ///< the way back to the level's files, if there is one
};

/// Writes what was found into the panel. A click on what stands in the level's files copies its
/// place in them, one on the point that itself.
InspectorRequest showInspection(const Inspection& found, const InspectedSurface& surface,
                                bool isPinned);

/// Lights that are listed, and whose rays are drawn.
inline constexpr std::size_t kMostListedLights = 8;

}  // namespace hearth
