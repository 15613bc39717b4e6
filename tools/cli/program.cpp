#include "cli/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/heap.h"
#include "cli/start_instead.h"
#include "math/check.h"
#include "settings/shell_text.h"

namespace hearth {

namespace {

/// Adds a row of the table to a command; what is given ends in `values`.
void addOption(CLI::App& app, const OptionRow& row, bool isRequired, OptionValues& values) {
  const std::string name(row.name);
  if (row.kind == ValueKind::Flag) {
    app.add_flag_callback(
        name, [&] { values.set(row.id, ""); }, helpOf(row));
    return;
  }
  if (row.kind == ValueKind::Texts || row.kind == ValueKind::EachText) {
    app.add_option_function<std::vector<std::string>>(
           name, [&](const std::vector<std::string>& all) { values.setAll(row.id, all); },
           helpOf(row))
        ->type_name(std::string(row.value))
        ->allow_extra_args(row.kind == ValueKind::Texts)
        ->required(isRequired);
    return;
  }
  const auto take = [&](const std::string& value) { values.set(row.id, value); };
  app.add_option_function<std::string>(name, take, helpOf(row))
      ->type_name(std::string(row.value))
      ->required(isRequired)
      ->check(CLI::Validator(
          [&](std::string& value) { return mistakeIn(row, value).value_or(std::string()); }, ""));
}

void addCommand(CLI::App& program, const Command& command, OptionValues& values) {
  CLI::App& app = *program.add_subcommand(std::string(command.name), std::string(command.help));
  if (command.moreOfUser)
    app.footer(command.moreOfUser);
  else
    app.footer(command.more);
  const std::string argument(command.argument);
  if (command.levels == LevelFiles::Several)
    app.add_option(argument, values.levels, "the level files")->required()->type_name("");
  else if (command.levels != LevelFiles::None)
    app.add_option(argument, values.level, "the level file")
        ->required(command.levels == LevelFiles::One)
        ->type_name("");
  for (const Option option : command.options) {
    const bool isRequired = std::ranges::find(command.required, option) != command.required.end();
    addOption(app, row(option), isRequired, values);
  }
}

ExitStatus parseAndRun(CLI::App& program, std::span<const Command> commands,
                       const OptionValues& values, int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  const auto command = std::ranges::find(commands, first, &Command::name);
  if (command == commands.end() && first != "-h" && first != "--help") {
    std::vector<std::string_view> names;
    for (const Command& known : commands) names.push_back(known.name);
    return fail(fmt::format(
        "{}; there are: {}; see `{} --help`",
        first.empty() ? "name a command" : fmt::format("there is no command \"{}\"", first),
        fmt::join(names, ", "), values.program));
  }
  if (command != commands.end() && !command->program.empty())
    return fail(startInstead(command->program, argv));
  const std::string_view name = command == commands.end() ? "" : command->name;
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    program.exit(help);
    return ExitStatus::Done;
  } catch (const CLI::ParseError& mistake) {
    return fail(fmt::format("{}; see `{} {}{}--help`", mistake.what(), values.program, name,
                            name.empty() ? "" : " "));
  }
  CHECK(command != commands.end(), first);  // asked for help, and gave none
  return command->run(values);
}

/// What was printed may still be on its way.
ExitStatus afterPrinting(ExitStatus status) {
  const bool isPrinted = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  return isPrinted ? status : fail("standard output cannot be written");
}

ExitStatus parseAndRun(std::string_view about, std::span<const Command> commands, int argc,
                       char** argv) {
  CLI::App program{std::string(about)};
  program.require_subcommand(1);
  OptionValues values;
  if (argc > 0) values.program = shellWord(argv[0]);
  for (const Command& command : commands) addCommand(program, command, values);
  return parseAndRun(program, commands, values, argc, argv);
}

}  // namespace

int runProgram(std::string_view about, std::span<const Command> commands, int argc, char** argv) {
  useHugePages();
  ExitStatus status{};
  try {
    status = afterPrinting(parseAndRun(about, commands, argc, argv));
  } catch (const std::bad_alloc&) {
    status = fail("not enough memory; larger --texel or a smaller --size needs less");
  } catch (const std::system_error& error) {  // the system gives no more threads
    status = fail(error.what());
  }
  return static_cast<int>(status);
}

}  // namespace hearth
