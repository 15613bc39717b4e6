#pragma once

#include <span>
#include <string_view>

#include "cli/command.h"

namespace hearth {

/// Runs the command that the arguments name and returns the program's exit status. `--help` prints
/// `about` and the commands.
int runProgram(std::string_view about, std::span<const Command> commands, int argc, char** argv);

}  // namespace hearth
