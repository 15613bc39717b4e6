#pragma once

#include <nlohmann/json_fwd.hpp>

#include "import/doom/findings.h"
#include "import/doom/ground_plan.h"
#include "import/doom/materials.h"

namespace hearth::doom {

/// A map as a level file holds it. `ambient` is the light of each sector, as a fraction of what the
/// map gives it.
nlohmann::ordered_json levelJson(const GroundPlan& plan, double ambient, Materials& materials,
                                 Findings& findings);

}  // namespace hearth::doom
