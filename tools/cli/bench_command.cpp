#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/start_instead.h"
#include "inputs/inputs.h"
#include "inputs/moved_light.h"
#include "measure/level_bench.h"
#include "measure/machine.h"
#include "settings/shell_text.h"

namespace hearth {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kBenchRepeats = 5;

double perSecond(double count, const BakeBench& bake) { return count / bake.seconds.median; }

Json toJson(const Spread& spread) { return {{"median", spread.median}, {"p95", spread.p95}}; }

Json toJson(const FrameBench& frame) {
  Json json{{"width", frame.size.width},
            {"height", frame.size.height},
            {"threads", frame.threads},
            {"milliseconds", toJson(frame.milliseconds)},
            {"writeMilliseconds", toJson(frame.writeMilliseconds)},
            {"writes", frame.writes()}};
  for (const FrameCounter& counter : frame.counters) json[std::string(counter.name)] = counter.mean;
  return json;
}

Json toJson(const BenchReport& report, const Machine& machine) {
  Json json{{"machine",
             {{"processor", machine.processor},
              {"threads", machine.threads},
              {"compiler", machine.compiler}}},
            {"repeats", report.repeats},
            {"drawnWith", optionsOf(report.drawSettings)}};
  json["frames"] = Json::array();
  for (const FrameBench& frame : report.frames) json["frames"].push_back(toJson(frame));
  json["bake"] = {{"texel", report.settings.texel},
                  {"samples", samplesInWords(report.settings)},
                  {"surfaces", report.bake.surfaces},
                  {"litSurfaces", report.bake.litSurfaces},
                  {"texels", report.bake.texels},
                  {"texelLightTests", report.texelLightTests},
                  {"rays", report.bake.rays},
                  {"bytes", report.bake.bytes},
                  {"times", Json::array()}};
  for (const BakeBench& bake : report.bakes)
    json["bake"]["times"].push_back(
        {{"threads", bake.threads},
         {"seconds", toJson(bake.seconds)},
         {"texelLightTestsPerSecond", perSecond(static_cast<double>(report.texelLightTests), bake)},
         {"raysPerSecond", perSecond(static_cast<double>(report.bake.rays), bake)}});
  return json;
}

std::string inWords(ImageSize size) { return fmt::format("{}x{}", size.width, size.height); }

/// A column for each size; threads do the same work.
void printCounters(std::span<const FrameBench> frames) {
  std::vector<FrameBench> sizes(frames.begin(), frames.end());
  std::erase_if(sizes, [](const FrameBench& frame) { return frame.threads != 1; });
  if (sizes.empty()) return;
  fmt::print("\n{:>16}", "work of a frame");
  for (const FrameBench& frame : sizes) fmt::print(" {:>11}", inWords(frame.size));
  fmt::print("\n");
  for (std::size_t i = 0; i < sizes.front().counters.size(); ++i) {
    fmt::print("{:>16}", sizes.front().counters[i].name);
    for (const FrameBench& frame : sizes) fmt::print(" {:>11.1f}", frame.counters[i].mean);
    fmt::print("\n");
  }
}

void print(const BenchReport& report, const Machine& machine) {
  const std::string drawnWith = optionsOf(report.drawSettings);
  fmt::print("{}, {} thread(s), {}; {} repeats{}\n\n", machine.processor, machine.threads,
             machine.compiler, report.repeats, drawnWith.empty() ? "" : "; " + drawnWith);
  fmt::print("{:>16} {:>8} {:>10} {:>10} {:>10}\n", "frame", "threads", "ms", "ms, p95", "writes");
  for (const FrameBench& frame : report.frames)
    fmt::print("{:>16} {:>8} {:>10.3f} {:>10.3f} {:>10.1f}\n", inWords(frame.size), frame.threads,
               frame.milliseconds.median, frame.milliseconds.p95, frame.writes());
  printCounters(report.frames);
  fmt::print("\nbake: {} texels of {} m, {}; {} texel-light tests, {} rays, {} bytes\n",
             report.bake.texels, report.settings.texel, samplesInWords(report.settings),
             report.texelLightTests, report.bake.rays, report.bake.bytes);
  fmt::print("{:>16} {:>8} {:>10} {:>10} {:>14} {:>14}\n", "", "threads", "s", "s, p95",
             "M tests/s", "M rays/s");
  for (const BakeBench& bake : report.bakes)
    fmt::print("{:>16} {:>8} {:>10.3f} {:>10.3f} {:>14.2f} {:>14.2f}\n", "", bake.threads,
               bake.seconds.median, bake.seconds.p95,
               perSecond(1e-6 * static_cast<double>(report.texelLightTests), bake),
               perSecond(1e-6 * static_cast<double>(report.bake.rays), bake));
}

std::optional<std::string> mistakeBesidePeers(const OptionValues& values) {
  if (!values.level.empty())
    return fmt::format("--peers: leave out {}: it measures levels of its own", values.level);
  const std::string given = typedOptions(values, drawOptions() + bakeOptions());
  if (!given.empty()) return fmt::format("--peers: its settings are given; leave out{}", given);
  return std::nullopt;
}

/// Runs hearth-peers, which lies beside this program where it is built, in this program's place.
ExitStatus runPeers(const OptionValues& values) {
  if (const auto mistake = mistakeBesidePeers(values)) return fail(*mistake);
  std::vector<std::string> words = {"hearth-peers", "run"};
  if (values.has(Option::Json)) words.emplace_back("--json");
  for (const Option option : {Option::Only, Option::Repeats})
    if (const auto text = values.text(option)) {
      words.emplace_back(row(option).name);
      words.push_back(*text);
    }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return fail(fmt::format("--peers: {}", startInstead(words.front(), arguments.data())));
}

ExitStatus runBench(const OptionValues& values) {
  if (values.has(Option::Peers)) return runPeers(values);
  if (values.level.empty()) return fail("name a level, or give --peers");
  if (values.has(Option::Only)) return fail("--only: it chooses rows of --peers");
  const OpenedLevel opened = loadAndReportWithSource(values);
  if (!opened.result.loaded) return ExitStatus::BadInput;
  const auto shares = moverSharesFor(opened.result.loaded->level, values);
  if (!shares) return fail(shares.error());
  const auto loaded = loadedAt(*opened.result.loaded, opened.source, *shares, values);
  if (!loaded) return fail(loaded.error());
  const auto settings = bakeSettingsFor((*loaded)->scene(), values);
  if (!settings) return fail(settings.error());
  const int threads = threadsFrom(values);
  const int repeats = static_cast<int>(values.number(Option::Repeats).value_or(kBenchRepeats));
  const BenchReport report =
      measure(**loaded, *settings, drawSettingsFrom(values), threads, repeats, steadySeconds);
  if (values.has(Option::Json))
    fmt::print("{}\n", toJson(report, thisMachine()).dump(1));
  else
    print(report, thisMachine());
  return ExitStatus::Done;
}

}  // namespace

Command benchCommand() {
  return {"bench",
          "measures frames of the level's shots and its bake, on one thread and on all",
          std::vector<Option>{Option::Repeats, Option::Mover, Option::Json, Option::Peers,
                              Option::Only} +
              drawOptions() + bakeOptions(),
          {},
          runBench,
          LevelFiles::OneOrNone};
}

}  // namespace hearth
