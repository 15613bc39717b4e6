#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "settings/options.h"

namespace hearth {

/// What the program returns to the shell.
enum class ExitStatus { Done = 0, Differs = 1, BadInput = 2 };

/// Prints `hearth: error: MESSAGE` to stderr, one line.
ExitStatus fail(std::string_view message);

/// How many level files a command is given.
enum class LevelFiles { None, OneOrNone, One, Several };

/// A command of the program, as help lists it.
struct Command {
  std::string_view name;
  std::string_view help;
  std::vector<Option> options;
  std::vector<Option> required;  ///< of the options
  ExitStatus (*run)(const OptionValues& values);
  LevelFiles levels = LevelFiles::One;
  std::string more = {};                  ///< that its help says after the options
  std::string_view argument = "LEVEL";    ///< what stands for the level files in the help
  std::string (*moreOfUser)() = nullptr;  ///< in place of `more`, where the user's files count
};

Command walkCommand();
Command shotCommand();
Command bakeCommand();
Command checkCommand();
Command lintCommand();
Command infoCommand();
Command mapCommand();
Command importCommand();
Command newCommand();
Command fmtCommand();
Command benchCommand();
Command tradeoffCommand();

/// All of these, as help lists them.
std::vector<Command> allCommands();

}  // namespace hearth
