#pragma once

#include "cli/command.h"

namespace hearth {

/// The one command of hearth-peers. It measures Hearth against other programs, limits of the
/// machine and targets.
Command peersCommand();

}  // namespace hearth
