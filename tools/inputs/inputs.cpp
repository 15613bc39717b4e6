#include "inputs/inputs.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "inputs/bake_cache.h"
#include "inputs/bake_file.h"
#include "math/parallel.h"
#include "render/texels_in_view.h"
#include "settings/options.h"
#include "settings/shell_text.h"

namespace hearth {

namespace {

/// What `work` bakes, its progress shown.
template <typename Work>
BakedLight whileShown(const OptionValues& values, ProgressStyle styleWithoutTerminal, Work&& work) {
  BakeProgress progress;
  const ProgressDisplay display(progressStyle(values, styleWithoutTerminal), progress);
  return work(progress);
}

std::optional<BakeCache> cacheFor(const OptionValues& values) {
  return values.has(Option::NoCache) ? std::nullopt : BakeCache::ofUser();
}

Bake bakeAndWarn(const Scene& scene, const BakeSettings& settings, const OptionValues& values,
                 ProgressStyle styleWithoutTerminal) {
  Bake bake = bakeWith(scene, settings, values, styleWithoutTerminal);
  warnIfDark(scene.level(), bake.light, values);
  return bake;
}

BakedLight cachedLight(const Scene& scene, const BakeSettings& settings,
                       const OptionValues& values) {
  const auto cache = cacheFor(values);
  if (cache) {
    if (auto light = cache->find(scene, settings)) {
      warnIfDark(scene.level(), *light, values);
      return std::move(*light);
    }
  }
  Bake bake = bakeAndWarn(scene, settings, values, ProgressStyle::None);
  if (cache) cache->keep(scene, settings, bake.light);
  return std::move(bake.light);
}

BakedLight noLight(const Scene& scene) {
  BakedLight none;
  none.surfaces.resize(scene.level().surfaces.size());
  none.lightmaps.resize(none.surfaces.size());
  return none;
}

}  // namespace

std::optional<std::string> warningIfDark(const Level& level, const BakedLight& light,
                                         const OptionValues& values) {
  if (light.stats.litSurfaces > 0) return std::nullopt;
  if (level.lights.empty())
    return fmt::format(
        "{}:1:1: warning: no lights are given, so only sector light shows, at /lights, give some "
        "in {}, or name another file of lights: \"lights\": ..",
        values.level, lightsBeside(values.level).filename().string());
  return fmt::format(
      "{}:1:1: warning: no light reaches any surface, so only sector light shows, at /lights, add "
      "lights or raise their intensity",
      values.level);
}

void warnIfDark(const Level& level, const BakedLight& light, const OptionValues& values) {
  if (const auto warning = warningIfDark(level, light, values))
    fmt::print(stderr, "{}\n", *warning);
}

OpenedLevel loadLevelOf(const OptionValues& values) {
  const ProgressDisplay display(progressStyle(values), Stage::Loading);
  return openLevel(values.level, limitsFrom(values));
}

std::shared_ptr<const LevelSource> takeSource(OpenedLevel& opened) {
  return opened.model ? nullptr : std::make_shared<const LevelSource>(std::move(opened.source));
}

void printDiagnostics(std::span<const Diagnostic> diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) fmt::print(stderr, "{}\n", format(diagnostic));
}

OpenedLevel loadAndReportWithSource(const OptionValues& values) {
  OpenedLevel opened = loadLevelOf(values);
  printDiagnostics(opened.result.diagnostics);
  return opened;
}

std::optional<LoadedLevel> loadAndReport(const OptionValues& values) {
  return loadAndReportWithSource(values).result.loaded;
}

LightMode lightModeFrom(const OptionValues& values) {
  const std::string mode = values.text(Option::Light).value_or("both");
  if (mode == "none") return LightMode::None;
  return mode == "only" ? LightMode::Only : LightMode::Both;
}

int threadsFrom(const OptionValues& values) {
  return static_cast<int>(values.number(Option::Threads).value_or(availableThreads()));
}

Bake bakeWith(const Scene& scene, const BakeSettings& settings, const OptionValues& values,
              ProgressStyle styleWithoutTerminal, LightMemory* memory) {
  const int threads = threadsFrom(values);
  const auto start = std::chrono::steady_clock::now();
  BakedLight light = whileShown(values, styleWithoutTerminal, [&](BakeProgress& progress) {
    if (!memory) return bake(scene, settings, threads, &progress);
    return *Rebake(*memory, scene, settings, threads).finish(&progress);  // nothing stops it
  });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return Bake{std::move(light), settings, threads, seconds.count()};
}

tl::expected<Bake, std::string> bakeFor(const Scene& scene, const OptionValues& values,
                                        ProgressStyle styleWithoutTerminal) {
  return bakeSettingsFor(scene, values).map([&](const BakeSettings& settings) {
    return bakeAndWarn(scene, settings, values, styleWithoutTerminal);
  });
}

tl::expected<BakedLight, std::string> lightFor(const Scene& scene, const OptionValues& values) {
  if (!values.has(Option::LightFrom))
    return bakeSettingsFor(scene, values).map([&](const BakeSettings& settings) {
      return cachedLight(scene, settings, values);
    });
  if (const std::string given = typedOptions(values, settingOptions()); !given.empty())
    return tl::unexpected(
        fmt::format("--light-from: this light is baked already; leave out{}", given));
  return readBake(scene, values);
}

tl::expected<BakedLight, std::string> lightInView(const Scene& scene, const Camera& camera,
                                                  const OptionValues& values) {
  const bool showsLight = lightModeFrom(values) != LightMode::None;
  if (values.has(Option::LightFrom) || (showsLight && cacheFor(values)))
    return lightFor(scene, values);
  return bakeSettingsFor(scene, values).map([&](const BakeSettings& settings) {
    if (!showsLight) return noLight(scene);
    LitSurfaces surfaces = makeLitSurfaces(scene, settings.texel);
    DrawSettings frame = drawSettingsFrom(values);
    if (values.has(Option::Channel)) frame.pixelSize = 1;  // channels have all pixels
    const auto seen = texelsInView(scene, surfaces, camera, frame);
    BakedLight light = whileShown(values, ProgressStyle::None, [&](BakeProgress& progress) {
      return bakeOnly(seen, std::move(surfaces), scene, settings, threadsFrom(values), &progress);
    });
    // Whether anything else is lit shows in a whole bake only.
    if (light.stats.litSurfaces > 0) return light;
    return bakeAndWarn(scene, settings, values, ProgressStyle::None).light;
  });
}

}  // namespace hearth
