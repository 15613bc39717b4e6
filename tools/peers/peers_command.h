#pragma once

#include "cli/command.h"

namespace hearth {

/// The one command of hearth-peers: measures Hearth against peers, limits and targets.
Command peersCommand();

}  // namespace hearth
