#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cli/command.h"
#include "cli/lightmap_atlas.h"
#include "cli/state_bakes.h"
#include "image/image_file.h"
#include "inputs/bake_file.h"
#include "inputs/inputs.h"
#include "inputs/part_files.h"
#include "measure/budget.h"

namespace hearth {

namespace {

std::string extensionOf(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

void printLight(const Bake& bake) {
  const BakeStats& stats = bake.light.stats;
  fmt::print("surfaces  {} of {} lit\n", stats.litSurfaces, stats.surfaces);
  fmt::print("texels    {} of {} m, {}\n", stats.texels, bake.settings.texel,
             samplesInWords(bake.settings));
}

void print(const Bake& bake) {
  printLight(bake);
  const BakeStats& stats = bake.light.stats;
  // A clock that did not move must not divide by zero.
  const double seconds = std::max(bake.seconds, 1e-9);
  fmt::print("speed     {:.0f} texels/s; {:.3g} rays/s on {} thread(s)\n",
             static_cast<double>(stats.texels) / seconds, static_cast<double>(stats.rays) / seconds,
             bake.threads);
  fmt::print("bytes     {}\n", stats.bytes);
  fmt::print("time      {:.3f} s\n", bake.seconds);
}

void print(const StateFigures& states) {
  fmt::print("states    {} more by {} mover(s): {:.3f} s, {} bytes; {} bytes kept meanwhile\n",
             states.count, states.movers, states.seconds, states.bytes, states.keptBytes);
}

/// The settings of the command line, or those that fit the time that it gives.
tl::expected<BakeSettings, std::string> settingsInTime(const Scene& scene,
                                                       const OptionValues& values) {
  const std::optional<double> budget = values.number(Option::TimeBudget);
  if (!budget) return bakeSettingsFor(scene, values);
  for (const Option option : {Option::Quality, Option::Texel, Option::Samples, Option::SoftSamples,
                              Option::CutOff, Option::GatherError})
    if (values.has(option))
      return tl::unexpected(fmt::format("give --time-budget or {}, not both", row(option).name));
  const auto settings = bakeSettingsFor(scene, values);
  if (!settings) return tl::unexpected(settings.error());
  const FittingBake fitting =
      bakeFitting(scene, *settings, *budget, threadsFrom(values), steadySeconds);
  if (!values.has(Option::Quiet)) fmt::print("picked    {}\n", words(fitting));
  return fitting.settings;
}

bool isSavedBake(const OptionValues& values) {
  return extensionOf(values.text(Option::Output).value_or("")) == ".bake";
}

/// Writes the light to the file of `-o`, if any. `bakes` is what a saved bake holds.
ExitStatus writeLight(const Scene& scene, const Bake& bake, std::string_view bakes,
                      const OptionValues& values) {
  const std::optional<std::string> output = values.text(Option::Output);
  if (!output) return ExitStatus::Done;
  const auto written = [&]() -> tl::expected<void, std::string> {
    const ProgressDisplay display(progressStyle(values), Stage::Writing);
    if (isSavedBake(values)) return writeBakes(*output, bakes);
    const auto image = lightmapAtlas(scene.level(), bake.light);
    if (!image) return tl::unexpected(image.error());
    return writePng(*output, *image);
  }();
  return written ? ExitStatus::Done : fail(written.error());
}

ExitStatus bakeAll(const OpenedLevel& opened, const OptionValues& values) {
  const Scene scene = opened.result.loaded->scene();
  const auto settings = settingsInTime(scene, values);
  if (!settings) return fail(settings.error());
  StateBakes states(opened, *settings, values, isSavedBake(values));
  const Bake bake = states.bakeAuthored();
  warnIfDark(scene.level(), bake.light, values);
  if (!values.has(Option::Quiet)) print(bake);
  const bool showsAuthoredOnly = values.has(Option::Output) && !isSavedBake(values);
  if (!scene.level().movers.empty() && !showsAuthoredOnly) {
    if (const auto mistake = states.bakeOthers()) return fail(*mistake);
    if (!values.has(Option::Quiet)) print(states.figures());
  }
  return writeLight(scene, bake, states.bytes(), values);
}

ExitStatus bakeShard(const Scene& scene, const OptionValues& values) {
  const PartNumber number = *parsePartNumber(*values.text(Option::Shard));
  const auto outcome = bakeInPartsFor(scene, values).and_then([&](const BakeInParts& bake) {
    return bakePartFile(bake, number, values);
  });
  if (!outcome) return fail(outcome.error());
  if (!values.has(Option::Quiet))
    fmt::print("part      {} of {}{}\n", number.part, number.parts,
               *outcome == PartOutcome::WasThere ? ", which was finished" : "");
  return ExitStatus::Done;
}

ExitStatus join(const Scene& scene, const OptionValues& values) {
  const auto bake = bakeInPartsFor(scene, values);
  if (!bake) return fail(bake.error());
  auto light = joinPartFiles(*bake, values);
  if (!light) return fail(light.error());
  const Bake joined{std::move(*light), bake->settings(), threadsFrom(values), 0};
  if (!values.has(Option::Quiet)) printLight(joined);
  return writeLight(scene, joined, isSavedBake(values) ? bytesOf(scene, joined) : "", values);
}

/// What does not go together, or with the file to write.
std::optional<std::string> mistakeIn(const OptionValues& values) {
  const std::optional<std::string> output = values.text(Option::Output);
  const std::string extension = extensionOf(output.value_or(""));
  for (const Option parts : {Option::Shard, Option::Join})
    if (values.has(parts) && values.has(Option::TimeBudget))
      return fmt::format("give {} or {}, not both: parts need one choice of settings",
                         row(Option::TimeBudget).name, row(parts).name);
  for (const Option parts : {Option::Shard, Option::Join})
    for (const Option states : {Option::MoverStages, Option::MoverStates})
      if (values.has(parts) && values.has(states))
        return fmt::format("give {} or {}, not both: parts are of the level as authored",
                           row(states).name, row(parts).name);
  if (values.has(Option::Shard) && values.has(Option::Join))
    return fmt::format("give {} or {}, not both", row(Option::Shard).name, row(Option::Join).name);
  if (values.has(Option::Shard) && !output)
    return fmt::format("{}: give the part a file with -o X.part", row(Option::Shard).name);
  if (values.has(Option::Shard) && extension != ".part")
    return fmt::format("-o: {}: a part of a bake is written as a .part", *output);
  if (!values.has(Option::Shard) && output && extension != ".png" && extension != ".bake")
    return fmt::format("-o: {}: light is written as a .bake to draw with or as a .png to look at",
                       *output);
  return std::nullopt;
}

ExitStatus runBake(const OptionValues& values) {
  if (const auto mistake = mistakeIn(values)) return fail(*mistake);
  const OpenedLevel opened = loadAndReportWithSource(values);
  if (!opened.result.loaded) return ExitStatus::BadInput;
  const Scene scene = opened.result.loaded->scene();
  if (values.has(Option::Shard)) return bakeShard(scene, values);
  return values.has(Option::Join) ? join(scene, values) : bakeAll(opened, values);
}

}  // namespace

Command bakeCommand() {
  return {"bake",
          "bakes the light and says what that took",
          std::vector<Option>{Option::Output, Option::TimeBudget, Option::MoverStages,
                              Option::MoverStates, Option::Shard, Option::Join, Option::Quiet} +
              bakeOptions(),
          {},
          runBake};
}

}  // namespace hearth
