#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "cli/command.h"
#include "cli/plan.h"
#include "files/replace_file.h"
#include "inputs/inputs.h"

namespace hearth {

namespace {

ExitStatus runMap(const OptionValues& values) {
  const std::string output = *values.text(Option::Output);
  if (std::filesystem::path(output).extension() != ".svg")
    return fail("-o: " + output + ": the plan is written as a .svg");
  const std::optional<LoadedLevel> loaded = loadAndReport(values);
  if (!loaded) return ExitStatus::BadInput;
  const std::string plan = planOf(loaded->scene());
  const auto written = replaceFile(output, [&](std::ostream& stream) {
    stream << plan;
    return stream.good();
  });
  if (!written) return fail(written.error());
  if (!values.has(Option::Quiet)) fmt::print(stderr, "{} written\n", output);
  return ExitStatus::Done;
}

}  // namespace

Command mapCommand() {
  return {"map",
          "draws the plan of the level, with names, heights, portals, lights and shots",
          std::vector<Option>{Option::Output, Option::Quiet} + limitOptions(),
          {Option::Output},
          runMap};
}

}  // namespace hearth
