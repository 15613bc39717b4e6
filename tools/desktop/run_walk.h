#pragma once

#include <string>

#include "cli/command.h"

namespace hearth {

/// What `hearth walk` does: loads and bakes a level, and walks it in a window.
ExitStatus runWalk(const OptionValues& values);

/// The keys of a walk, as the user has set them.
std::string keyHelpOfUser();

}  // namespace hearth
