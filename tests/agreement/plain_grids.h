#pragma once

#include <optional>
#include <vector>

#include "agreement/panel.h"

namespace hearth::agreement {

/// The axes along which the texels of each surface lie, (0, 0) at their origin; by index of
/// surface. `panels` are those of the surfaces.
std::vector<Axes> plainGrids(const Scene& scene, const std::vector<std::optional<Panel>>& panels);

}  // namespace hearth::agreement
