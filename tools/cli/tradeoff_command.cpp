#include <fmt/format.h>

#include <utility>
#include <vector>

#include "cli/command.h"
#include "inputs/inputs.h"
#include "measure/tradeoff/area_trials.h"
#include "measure/tradeoff/mover_trials.h"
#include "measure/tradeoff/page.h"
#include "measure/tradeoff/report.h"
#include "measure/tradeoff/trials.h"
#include "settings/approximations.h"

namespace hearth {

namespace {

constexpr ImageSize kTruthSize{160, 100};
constexpr int kTrialRepeats = 3;

constexpr std::string_view kMore =
    R"(Bakes and frames of each setting are timed in turn with those of the level's
own. What it costs, x, is the median of the ratios of neighbours in time, so a
machine that gets slower meanwhile changes it little; seconds are that times
what the level's own took, as a median over the whole run. What takes longer
than the level's own is repeated less often, but once at least.)";

std::string_view whatItMakes(Approximation::Of of) {
  switch (of) {
    case Approximation::Of::Bake:
      return "bakes shorter or longer";
    case Approximation::Of::Frame:
      return "frames faster or slower";
    case Approximation::Of::Movers:
      return "bakes of movers more or fewer";
  }
  return "";
}

void printList() {
  for (const Approximation& approximation : approximations()) {
    const OptionRow& setting = row(approximation.setting);
    fmt::print("{} {}\n  {}\n", setting.name, setting.value, helpOf(setting));
    fmt::print("  makes {}; error: {}\n  {}\n", whatItMakes(approximation.of), approximation.bound,
               approximation.code);
  }
}

/// Tells how far a long measurement is.
class Told {
 public:
  explicit Told(bool isQuiet) : isQuiet_(isQuiet) {}
  void tell(std::string_view what, std::size_t done, std::size_t of) const {
    if (!isQuiet_) fmt::print(stderr, "{} {} of {}\n", what, done, of);
  }

 private:
  bool isQuiet_;
};

int repeatsFrom(const OptionValues& values) {
  return static_cast<int>(values.number(Option::Repeats).value_or(kTrialRepeats));
}

tl::expected<TradeoffReport, std::string> measured(LoadedLevel loaded, OptionValues values) {
  if (loaded.level.shots.empty())
    return tl::unexpected(fmt::format(
        "{}: what errors are seen is measured in the level's shots: give it some", values.level));
  // The pictures of truth have no light of areas. So neither has what is held against them.
  loaded.level.bake.bounces =
      static_cast<int>(values.number(Option::Bounces).value_or(loaded.level.bake.bounces));
  values.unset(Option::Bounces);
  if (takeOutAreas(loaded.level))
    fmt::print(stderr,
               "{}: light of the sky, of surfaces that shine, and that bounces is not measured: "
               "--areas does\n",
               values.level);
  auto trials = trialsFor(loaded.scene(), values);
  if (!trials) return tl::unexpected(trials.error());

  TradeoffReport report;
  report.level = values.level;
  report.machine = thisMachine();
  report.truthSize = parseSize(values.text(Option::Size).value_or("")).value_or(kTruthSize);
  TrialSetup setup;
  setup.threads = threadsFrom(values);
  setup.repeats = repeatsFrom(values);
  setup.clock = steadySeconds;
  const Told told(values.has(Option::Quiet));
  setup.onProgress = [&](std::size_t done) { told.tell("settings", done, trials->size()); };
  report.bakeThreads = setup.threads;
  report.frameSize = setup.frameSize;
  const auto truth = truthOf(loaded, report.truthSize, setup.threads, [&](std::size_t done) {
    told.tell("truth of shot", done, loaded.level.shots.size());
  });
  report.trials = measureTrials(loaded, *trials, truth, setup);
  return reportOf(std::move(report));
}

template <typename Report>
ExitStatus writePageIfAsked(const OptionValues& values, const Report& report) {
  const std::optional<std::string> page = values.text(Option::Report);
  if (!page) return ExitStatus::Done;
  const auto written = writeTradeoffPage(*page, report);
  return written ? ExitStatus::Done : fail(written.error());
}

std::vector<double> triedValues(Option setting) {
  const auto found = std::ranges::find(approximations(), setting, &Approximation::setting);
  std::vector<double> values;
  for (const std::string_view value : triedOf(*found))
    values.push_back(parseNumbers(value)->front());
  return values;
}

std::vector<int> triedStages() {
  std::vector<int> counts;
  for (const double value : triedValues(Option::MoverStages))
    counts.push_back(static_cast<int>(value));
  return counts;
}

/// Gather errors, and fewer bounces than a level's.
std::vector<AreaSetting> triedOfAreas(int bounces) {
  std::vector<AreaSetting> tried;
  for (const double value : triedValues(Option::GatherError))
    tried.push_back({AreaSetting::Of::GatherError, value});
  for (int fewer = bounces - 1; fewer >= 0; --fewer)
    tried.push_back({AreaSetting::Of::Bounces, static_cast<double>(fewer)});
  return tried;
}

ExitStatus tradeAreas(const OptionValues& values) {
  const std::optional<LoadedLevel> loaded = loadAndReport(values);
  if (!loaded) return ExitStatus::BadInput;
  const auto settings = bakeSettingsFor(loaded->scene(), values);
  if (!settings) return fail(settings.error());
  if (settings->bounces == 0 && std::ranges::none_of(loaded->level.lights, &LightSource::isArea))
    return fail(fmt::format(
        "{}: --areas: the level has no sky light and no emitters, and no light bounces; --bounces "
        "1 lets it",
        values.level));
  AreaTrialSetup setup;
  setup.threads = threadsFrom(values);
  setup.clock = steadySeconds;
  setup.repeats = repeatsFrom(values);
  const std::vector<AreaSetting> tried = triedOfAreas(settings->bounces);
  const Told told(values.has(Option::Quiet));
  setup.onProgress = [&](std::size_t done) { told.tell("settings", done, tried.size()); };
  const AreaReport report{values.level, thisMachine(), setup.threads, settings->bounces,
                          measureAreas(*loaded, *settings, tried, setup)};
  fmt::print("{}", values.has(Option::Csv) ? csvOf(report.trials) : tableOf(report.trials));
  return writePageIfAsked(values, report);
}

ExitStatus tradeMovers(const OptionValues& values) {
  const OpenedLevel opened = loadAndReportWithSource(values);
  if (!opened.result.loaded) return ExitStatus::BadInput;
  const LoadedLevel& authored = *opened.result.loaded;
  if (authored.level.movers.empty())
    return fail(fmt::format("{}: --movers: the level has no movers", values.level));
  const auto settings = bakeSettingsFor(authored.scene(), values);
  if (!settings) return fail(settings.error());
  MoverTrialSetup setup;
  setup.threads = threadsFrom(values);
  setup.clock = steadySeconds;
  setup.repeats = repeatsFrom(values);
  const auto trials = measureMovers(authored, opened.source, *settings, triedStages(), setup);
  if (!trials) return fail(trials.error());
  fmt::print("{}", values.has(Option::Csv) ? csvOf(*trials) : tableOf(*trials));
  return ExitStatus::Done;
}

ExitStatus runTradeoff(const OptionValues& values) {
  if (values.has(Option::List)) {
    printList();
    return ExitStatus::Done;
  }
  if (values.level.empty())
    return fail(
        fmt::format("LEVEL is required, or --list; see `{} tradeoff --help`", values.program));
  if (values.has(Option::Movers) && values.has(Option::Areas))
    return fail("--movers and --areas measure different settings: give one of them");
  if (values.has(Option::Movers)) return tradeMovers(values);
  if (values.has(Option::Areas)) return tradeAreas(values);
  std::optional<LoadedLevel> loaded = loadAndReport(values);
  if (!loaded) return ExitStatus::BadInput;
  const auto report = measured(*std::move(loaded), values);
  if (!report) return fail(report.error());
  fmt::print("{}", values.has(Option::Csv) ? csvOf(*report) : tableOf(*report));
  return writePageIfAsked(values, *report);
}

}  // namespace

Command tradeoffCommand() {
  return {
      .name = "tradeoff",
      .help = "measures what settings cost on a level, and how far off they are",
      .options = std::vector<Option>{Option::List, Option::Csv, Option::Movers, Option::Areas,
                                     Option::Report, Option::Size, Option::Repeats, Option::Quiet} +
                 drawOptions() + bakeOptions(),
      .required = {},
      .run = runTradeoff,
      .levels = LevelFiles::OneOrNone,
      .more = std::string(kMore)};
}

}  // namespace hearth
