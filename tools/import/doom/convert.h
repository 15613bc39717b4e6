#pragma once

#include <nlohmann/json_fwd.hpp>

#include "import/doom/findings.h"
#include "import/doom/ground_plan.h"
#include "import/doom/materials.h"

namespace hearth::doom {

/// A map as the content of a level file. `ambient` is the fraction of a sector's light in the map
/// that its sector in the level gets.
nlohmann::ordered_json levelJson(const GroundPlan& plan, double ambient, Materials& materials,
                                 Findings& findings);

}  // namespace hearth::doom
