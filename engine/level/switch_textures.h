#pragma once

#include <span>

#include "level/level.h"

namespace hearth {

/// Gives the surfaces of switches the textures that they show with the movers at these shares:
/// those of a switch that is on if any mover that it starts is not where it is authored.
void showSwitches(Level& level, std::span<const double> shares);

}  // namespace hearth
