#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/command.h"
#include "cli/lightmap_atlas.h"
#include "image/image_file.h"
#include "inputs/bake_file.h"
#include "inputs/inputs.h"
#include "measure/budget.h"

namespace hearth {

namespace {

void print(const Bake& bake) {
  const BakeStats& stats = bake.light.stats;
  // A clock that did not move must not divide by zero.
  const double seconds = std::max(bake.seconds, 1e-9);
  fmt::print("surfaces  {} of {} lit\n", stats.litSurfaces, stats.surfaces);
  fmt::print("texels    {} of {} m, {}\n", stats.texels, bake.settings.texel,
             samplesInWords(bake.settings));
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

ExitStatus runBake(const OptionValues& values) {
  const std::optional<std::string> output = values.text(Option::Output);
  const auto extension = std::filesystem::path(output.value_or("")).extension();
  if (output && extension != ".png" && extension != ".bake")
    return fail(fmt::format(
        "-o: {}: light is written as a .bake to draw with or as a .png to look at", *output));
  const std::optional<LoadedLevel> loaded = loadAndReport(values);
  if (!loaded) return ExitStatus::BadInput;
  const auto bake = bakeInTime(loaded->scene(), values);
  if (!bake) return fail(bake.error());
  if (!values.has(Option::Quiet)) print(*bake);
  if (!output) return ExitStatus::Done;
  const auto written = [&]() -> tl::expected<void, std::string> {
    const ProgressDisplay display(progressStyle(values), Stage::Writing);
    if (extension == ".bake") return writeBake(*output, loaded->scene(), *bake);
    const auto image = lightmapAtlas(loaded->level, bake->light);
    if (!image) return tl::unexpected(image.error());
    return writePng(*output, *image);
  }();
  return written ? ExitStatus::Done : fail(written.error());
}

}  // namespace

Command bakeCommand() {
  return {"bake",
          "bakes the light and says what that took",
          std::vector<Option>{Option::Output, Option::TimeBudget, Option::Quiet} + bakeOptions(),
          {},
          runBake};
}

}  // namespace hearth
