#include "hearth/bench/peers_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "hearth/bench/machine.h"
#include "hearth/bench/peer_inputs.h"
#include "hearth/bench/peer_rows.h"
#include "hearth/bench/peer_table.h"
#include "hearth/shell_text.h"

namespace hearth {

namespace {

constexpr int kRepeats = 5;

std::optional<std::string> mistakeInOptions(const OptionValues& values) {
  if (!values.level.empty())
    return fmt::format("--peers: leave out {}: it measures levels of its own", values.level);
  const std::string given = typedOptions(values, drawOptions() + bakeOptions());
  if (!given.empty()) return fmt::format("--peers: its settings are given; leave out{}", given);
  return std::nullopt;
}

/// The rows whose names begin with what is asked for.
std::vector<PeerRow> rowsFrom(const OptionValues& values) {
  std::vector<PeerRow> rows(peerRows().begin(), peerRows().end());
  const std::string only = values.text(Option::Only).value_or("");
  std::erase_if(rows, [&](const PeerRow& row) { return !row.name.starts_with(only); });
  return rows;
}

}  // namespace

ExitStatus benchPeers(const OptionValues& values) {
  if (const auto mistake = mistakeInOptions(values)) return fail(*mistake);
  PeerInputs inputs("levels", steadySeconds);
  for (const std::filesystem::path& file : {inputs.keepFile(), inputs.tutorialFile()})
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

}  // namespace hearth
