#pragma once

#include <nlohmann/json_fwd.hpp>

#include "import/doom/ground_plan.h"
#include "import/doom/light_table.h"

namespace hearth::doom {

/// The lights of a map as a lights file holds them: where its things shine, and before the walls,
/// floors and ceilings that do.
nlohmann::ordered_json lightsJson(const GroundPlan& plan, const LightTable& table,
                                  Findings& findings);

}  // namespace hearth::doom
