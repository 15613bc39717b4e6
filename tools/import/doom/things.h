#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "import/doom/findings.h"
#include "import/doom/game.h"
#include "import/doom/ground_plan.h"
#include "import/doom/map.h"
#include "import/doom/sprites.h"
#include "load/limits.h"

namespace hearth::doom {

/// More are refused where levels are loaded.
inline constexpr std::size_t kMaxSpriteImages = LoadLimits{}.spriteImages;

struct ThingSettings {
  Game game{};
  bool hasMonsters = false;                  ///< they stand about
  std::size_t maxImages = kMaxSpriteImages;  ///< of all sprites together
};

/// What stands in a level: the things of its map that are seen, as sprites.
nlohmann::ordered_json spritesJson(const GroundPlan& plan, Sprites& sprites,
                                   const ThingSettings& settings, Findings& findings);

/// All the map says of its things, for other programs.
nlohmann::ordered_json allThingsJson(const Map& map);

}  // namespace hearth::doom
