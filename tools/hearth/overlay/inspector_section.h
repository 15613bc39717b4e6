#pragma once

#include <optional>

#include "hearth/inspect/inspect.h"
#include "image/image.h"
#include "render/texture.h"

namespace hearth {

/// What is asked of the section with the pointer.
struct InspectorRequest {
  std::optional<std::size_t> light = {};  ///< that it is on: an index into the findings
  bool letsGo = false;                    ///< of what is pinned
};

/// Writes what was found into the panel. `texture` is what the surface wears.
InspectorRequest showInspection(const Inspection& found, const Level& level, const Texture& texture,
                                bool isPinned);

/// Lights that are listed, and whose rays are drawn.
inline constexpr std::size_t kMostListedLights = 8;

}  // namespace hearth
