#include "peers/peers_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "measure/machine.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"
#include "peers/peer_table.h"

namespace hearth {

namespace {

constexpr int kRepeats = 5;

/// The rows whose names begin with what is asked for.
std::vector<PeerRow> rowsFrom(const OptionValues& values) {
  std::vector<PeerRow> rows(peerRows().begin(), peerRows().end());
  const std::string only = values.text(Option::Only).value_or("");
  std::erase_if(rows, [&](const PeerRow& row) { return !row.name.starts_with(only); });
  return rows;
}

ExitStatus run(const OptionValues& values) {
  PeerInputs inputs("levels", steadySeconds);
  for (const std::filesystem::path& file : {inputs.castleFile(), inputs.tutorialFile()})
    if (!exists(file))
      return fail(
          fmt::format("{}: there is no such file; --peers is run where levels/ is", file.string()));
  const std::vector<PeerRow> rows = rowsFrom(values);
  if (rows.empty()) return fail("--only: no row has a name that begins so");
  const int repeats = static_cast<int>(values.number(Option::Repeats).value_or(kRepeats));
  const auto tell = [](std::string_view what) { fmt::print(stderr, "{}\n", what); };
  const std::vector<PeerResult> results = measurePeers(rows, inputs, repeats, tell);
  fmt::print("{}", values.has(Option::Json) ? jsonOf(results, thisMachine(), repeats)
                                            : tableOf(results, thisMachine(), repeats));
  return ExitStatus::Done;
}

}  // namespace

Command peersCommand() {
  return {"run",
          "measures all rows of the table, or those that --only names",
          {Option::Only, Option::Repeats, Option::Json},
          {},
          run,
          LevelFiles::None};
}

}  // namespace hearth
