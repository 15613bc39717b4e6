#pragma once

#include <cstddef>

#include "load/json/report.h"
#include "load/read/description.h"

namespace hearth {

/// Writes the sectors of the level's grid out, behind its other sectors. Reports blanks that show,
/// names of unknown sectors, and that all sectors together have more vertices than allowed.
void expandGrid(Report& report, std::size_t maxVertices, LevelDescription& level);

}  // namespace hearth
