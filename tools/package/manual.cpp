// usage: hearth-manual < hearth.1.in > hearth.1
//
// Copies the manual page, with the commands and options of the program in place of the two lines
// that stand for them: the tables that the program works from are the only home of both.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"

namespace hearth {

namespace {

/// Text as troff prints it unchanged: minus signs stay such, and no line begins a request. Lines
/// may end between choices.
std::string troff(std::string_view text) {
  std::string escaped;
  bool beginsLine = true;
  for (const char c : text) {
    if (beginsLine && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else if (c == '|')
      escaped += "|\\:";
    else
      escaped += c;
    beginsLine = c == '\n';
  }
  return escaped;
}

/// Names that no line end may cut.
std::string listed(const std::vector<std::string_view>& names) {
  std::vector<std::string> whole;
  for (const std::string_view name : names) whole.push_back("\\%" + troff(name));
  return fmt::format("{}", fmt::join(whole, ", "));
}

void printCommand(const Command& command) {
  std::vector<std::string_view> names;
  for (const Option option : command.options) names.push_back(row(option).name);
  fmt::print(".TP\n.B hearth {} \\fI{}\\fR{}\n{}.\n", command.name, command.argument,
             command.levels == LevelFiles::Several ? "..." : "", troff(command.help));
  fmt::print("Takes {}.\n", names.empty() ? "no options" : listed(names));
  if (!command.more.empty()) fmt::print(".IP\n.EX\n{}\n.EE\n", troff(command.more));
}

void printOption(const OptionRow& row, const std::vector<std::string_view>& commands) {
  fmt::print(".TP\n.B {} \\fI\\%{}\\fR\n{}.\n", troff(row.name), troff(row.value),
             troff(helpOf(row)));
  fmt::print("({})\n", listed(commands));
}

void printOptions(const std::vector<Command>& commands) {
  std::set<Option> all;
  for (const Command& command : commands)
    all.insert(command.options.begin(), command.options.end());
  for (const Option option : all) {
    std::vector<std::string_view> takers;
    for (const Command& command : commands)
      if (std::ranges::find(command.options, option) != command.options.end())
        takers.push_back(command.name);
    printOption(row(option), takers);
  }
}

void printManual(std::istream& page) {
  const std::vector<Command> commands = allCommands();
  for (std::string line; std::getline(page, line);) {
    if (line == ".\\\" commands")
      std::ranges::for_each(commands, printCommand);
    else if (line == ".\\\" options")
      printOptions(commands);
    else
      fmt::print("{}\n", line);
  }
}

}  // namespace

}  // namespace hearth

int main() {
  hearth::printManual(std::cin);
  return 0;
}
