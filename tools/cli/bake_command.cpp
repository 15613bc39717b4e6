#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/command.h"
#include "cli/lightmap_atlas.h"
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

/// With the settings of the command line, or those that fit the time that it gives.
tl::expected<Bake, std::string> bakeInTime(const Scene& scene, const OptionValues& values) {
  const std::optional<double> budget = values.number(Option::TimeBudget);
  if (!budget) return bakeFor(scene, values, ProgressStyle::Lines);
  for (const Option option :
       {Option::Quality, Option::Texel, Option::Samples, Option::SoftSamples, Option::CutOff})
    if (values.has(option))
      return tl::unexpected(fmt::format("give --time-budget or {}, not both", row(option).name));
  const auto settings = bakeSettingsFor(scene, values);
  if (!settings) return tl::unexpected(settings.error());
  const FittingBake fitting =
      bakeFitting(scene, *settings, *budget, threadsFrom(values), steadySeconds);
  if (!values.has(Option::Quiet)) fmt::print("picked    {}\n", words(fitting));
  return bakeWith(scene, fitting.settings, values, ProgressStyle::Lines);
}

/// Writes the light to the file of `-o`, if any.
ExitStatus writeLight(const Scene& scene, const Bake& bake, const OptionValues& values) {
  const std::optional<std::string> output = values.text(Option::Output);
  if (!output) return ExitStatus::Done;
  const auto written = [&]() -> tl::expected<void, std::string> {
    const ProgressDisplay display(progressStyle(values), Stage::Writing);
    if (extensionOf(*output) == ".bake") return writeBake(*output, scene, bake);
    const auto image = lightmapAtlas(scene.level(), bake.light);
    if (!image) return tl::unexpected(image.error());
    return writePng(*output, *image);
  }();
  return written ? ExitStatus::Done : fail(written.error());
}

ExitStatus bakeAll(const Scene& scene, const OptionValues& values) {
  const auto bake = bakeInTime(scene, values);
  if (!bake) return fail(bake.error());
  if (!values.has(Option::Quiet)) print(*bake);
  return writeLight(scene, *bake, values);
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
  return writeLight(scene, joined, values);
}

/// What does not go together, or with the file to write.
std::optional<std::string> mistakeIn(const OptionValues& values) {
  const std::optional<std::string> output = values.text(Option::Output);
  const std::string extension = extensionOf(output.value_or(""));
  for (const Option parts : {Option::Shard, Option::Join})
    if (values.has(parts) && values.has(Option::TimeBudget))
      return fmt::format("give {} or {}, not both: parts need one choice of settings",
                         row(Option::TimeBudget).name, row(parts).name);
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
  const std::optional<LoadedLevel> loaded = loadAndReport(values);
  if (!loaded) return ExitStatus::BadInput;
  const Scene scene = loaded->scene();
  if (values.has(Option::Shard)) return bakeShard(scene, values);
  return values.has(Option::Join) ? join(scene, values) : bakeAll(scene, values);
}

}  // namespace

Command bakeCommand() {
  return {"bake",
          "bakes the light and says what that took",
          std::vector<Option>{Option::Output, Option::TimeBudget, Option::Shard, Option::Join,
                              Option::Quiet} +
              bakeOptions(),
          {},
          runBake};
}

}  // namespace hearth
