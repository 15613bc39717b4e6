#include "peers/peer_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace hearth {

namespace {

using Json = nlohmann::ordered_json;

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

std::string inWords(const PeerResult& result) {
  const PeerRow& row = *result.row;
  const std::string unit = row.unit.empty() ? "" : fmt::format(", {}", row.unit);
  std::string words = fmt::format("{:<16} {}{}\n", row.name, row.what, unit);
  const auto add = [&](const std::string& line) {
    words += fmt::format("{:>16}   {}\n", "", line);
  };
  if (!result.missing.empty()) {
    add("not measured: " + result.missing);
    return words;
  }
  add(fmt::format("{:<32} {:<8} {}", inWords(result.figure), inWords(row.target),
                  verdictOn(row.target, result.figure.median)));
  if (const auto part = inTheWay(result))
    add(fmt::format("in the way: {}: {}", row.parts[*part], inWords(result.parts[*part])));
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    add(fmt::format("  {}: {}", row.parts[i], inWords(result.parts[i])));
  return words;
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
  if (const auto part = inTheWay(result)) json["inTheWay"] = row.parts[*part];
  json["parts"] = Json::object();
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    json["parts"][std::string(row.parts[i])] = toJson(result.parts[i]);
  return json;
}

}  // namespace

std::string tableOf(std::span<const PeerResult> results, const Machine& machine, int repeats) {
  std::string table =
      fmt::format("{}, {} thread(s), {}; medians of {} repeats, with the least and the most\n\n",
                  machine.processor, machine.threads, machine.compiler, repeats);
  for (const PeerResult& result : results) table += inWords(result);
  return table;
}

std::string jsonOf(std::span<const PeerResult> results, const Machine& machine, int repeats) {
  Json json{{"machine",
             {{"processor", machine.processor},
              {"threads", machine.threads},
              {"compiler", machine.compiler}}},
            {"repeats", repeats},
            {"rows", Json::array()}};
  for (const PeerResult& result : results) json["rows"].push_back(toJson(result));
  return json.dump(1) + "\n";
}

}  // namespace hearth
