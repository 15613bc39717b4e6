#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "import/doom/game.h"
#include "import/doom/ground_plan.h"
#include "import/doom/light_table.h"
#include "load/limits.h"

namespace hearth::doom {

/// More are refused where levels are loaded.
inline constexpr std::size_t kMaxLights = LoadLimits{}.lights;

/// The lights of a map as a lights file holds them: where its things shine, and before the walls,
/// floors and ceilings that do.
nlohmann::ordered_json lightsJson(const GroundPlan& plan, const LightTable& table, const Game& game,
                                  Findings& findings, std::size_t maxLights = kMaxLights);

}  // namespace hearth::doom
