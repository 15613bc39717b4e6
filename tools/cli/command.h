#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "settings/options.h"

namespace hearth {

/// The program's exit status.
enum class ExitStatus { Done = 0, Differs = 1, BadInput = 2 };

/// Prints `hearth: error: MESSAGE` to stderr, one line.
ExitStatus fail(std::string_view message);

/// How many level files a command takes.
enum class LevelFiles { None, OneOrNone, One, Several };

/// A command of the program, as help lists it.
struct Command {
  std::string_view name;
  std::string_view help;
  std::vector<Option> options;
  std::vector<Option> required = {};  ///< of the options
  ExitStatus (*run)(const OptionValues& values) = nullptr;
  LevelFiles levels = LevelFiles::One;
  std::string more = {};                  ///< text of its help after the options
  std::string_view argument = "LEVEL";    ///< the placeholder of the level files in the help
  std::string (*moreOfUser)() = nullptr;  ///< replaces `more` if the user's files matter
  std::string_view program = {};          ///< if not empty, what runs the command instead of `run`
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

/// All commands, as help lists them.
std::vector<Command> allCommands();

}  // namespace hearth
