#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "import/doom/movers.h"
#include "worlds/world.h"

namespace hearth::worlds {

/// What became of the lines of a map that do something in Doom.
struct MovingWorld {
  std::string map;
  std::vector<std::string> errors;  ///< of import and loading, and lines that nothing is said of
  std::size_t movers = 0;
  std::vector<doom::LineFate> lines;
  /// Whether the player may come to a line that ends the map; none if it has none.
  std::optional<bool> isExitReached;
};

/// Imports and loads a map. Its files stand in `folder` for the time.
MovingWorld importMoving(const Archive& archive, const std::string& map,
                         const std::filesystem::path& folder);

/// Tables in Markdown: lines by what they do, and by the reasons for which they are left out.
std::string fateTables(const std::vector<MovingWorld>& worlds);

}  // namespace hearth::worlds
