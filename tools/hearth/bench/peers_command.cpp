#include "hearth/bench/peers_command.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "hearth/bench/machine.h"
#include "hearth/bench/peer_inputs.h"
#include "hearth/bench/peer_rows.h"
#include "hearth/shell_text.h"

namespace hearth {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kRepeats = 5;

// --- As text -------------------------------------------------------------------------------------

/// In three digits, or in all that stand before the point.
std::string inWords(double number) {
  const double digits = number == 0 ? 0 : std::floor(std::log10(std::abs(number)));
  return fmt::format("{:.{}f}", number, std::max(0, 2 - static_cast<int>(digits)));
}

std::string inWords(const Range& range) {
  return fmt::format("{} ({}..{})", inWords(range.median), inWords(range.min), inWords(range.max));
}

std::string inWords(const Target& target) {
  return fmt::format("{} {}", target.wanted == Wanted::AtMost ? "<=" : ">=", target.value);
}

std::string verdictOn(const Target& target, double measured) {
  const double missed = shortfall(target, measured);
  return missed == 0 ? "met" : fmt::format("short by {:.0f} %", std::ceil(100 * missed));
}

void print(const PeerResult& result) {
  const PeerRow& row = *result.row;
  const std::string unit = row.unit.empty() ? "" : fmt::format(", {}", row.unit);
  fmt::print("{:<16} {}{}\n", row.name, row.what, unit);
  if (!result.missing.empty()) {
    fmt::print("{:>16}   not measured: {}\n", "", result.missing);
    return;
  }
  fmt::print("{:>16}   {:<32} {:<8} {}\n", "", inWords(result.figure), inWords(row.target),
             verdictOn(row.target, result.figure.median));
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    fmt::print("{:>16}     {}: {}\n", "", row.parts[i], inWords(result.parts[i]));
}

void print(std::span<const PeerResult> results, const Machine& machine, int repeats) {
  fmt::print("{}, {} thread(s), {}; medians of {} repeats, with the least and the most\n\n",
             machine.processor, machine.threads, machine.compiler, repeats);
  for (const PeerResult& result : results) print(result);
}

// --- As JSON -------------------------------------------------------------------------------------

Json toJson(const Range& range) {
  return {{"median", range.median}, {"min", range.min}, {"max", range.max}};
}

Json toJson(const PeerResult& result) {
  const PeerRow& row = *result.row;
  Json json{{"name", row.name},
            {"what", row.what},
            {"unit", row.unit},
            {row.target.wanted == Wanted::AtMost ? "atMost" : "atLeast", row.target.value}};
  if (!result.missing.empty()) {
    json["missing"] = result.missing;
    return json;
  }
  json["measured"] = toJson(result.figure);
  json["shortfall"] = shortfall(row.target, result.figure.median);
  json["parts"] = Json::object();
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    json["parts"][std::string(row.parts[i])] = toJson(result.parts[i]);
  return json;
}

Json toJson(std::span<const PeerResult> results, const Machine& machine, int repeats) {
  Json json{{"machine",
             {{"processor", machine.processor},
              {"threads", machine.threads},
              {"compiler", machine.compiler}}},
            {"repeats", repeats},
            {"rows", Json::array()}};
  for (const PeerResult& result : results) json["rows"].push_back(toJson(result));
  return json;
}

// --- The command ---------------------------------------------------------------------------------

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
  if (values.has(Option::Json))
    fmt::print("{}\n", toJson(results, thisMachine(), repeats).dump(1));
  else
    print(results, thisMachine(), repeats);
  return ExitStatus::Done;
}

}  // namespace hearth
