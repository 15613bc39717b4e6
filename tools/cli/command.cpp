#include "cli/command.h"

#include <fmt/format.h>

#include <cstdio>

namespace hearth {

ExitStatus fail(std::string_view message) {
  fmt::print(stderr, "hearth: error: {}\n", message);
  return ExitStatus::BadInput;
}

std::vector<Command> allCommands() {
  return {newCommand(),  importCommand(), fmtCommand(),   walkCommand(),
          shotCommand(), bakeCommand(),   checkCommand(), lintCommand(),
          infoCommand(), mapCommand(),    benchCommand(), tradeoffCommand()};
}

}  // namespace hearth
