#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "inputs/progress.h"
#include "light/bakery.h"
#include "light/rebake.h"
#include "load/load.h"
#include "model/open_level.h"
#include "render/camera.h"
#include "render/renderer.h"
#include "settings/options.h"
#include "settings/settings.h"

/// The steps that commands share: from options to a level, a bake and a camera. Functions named
/// `...For` check what the options ask for, and return an error if it cannot be done. Those named
/// `...From` only read the options.
namespace hearth {

/// Loads the level or the model that the command line names, within the limits that it gives.
/// Diagnostics go to stderr, one per line. Returns nullopt if there are errors.
std::optional<LoadedLevel> loadAndReport(const OptionValues& values);

/// The same, with the source of the level. Its `result.loaded` is empty after errors.
OpenedLevel loadAndReportWithSource(const OptionValues& values);

/// Loads it so without printing its diagnostics.
OpenedLevel loadLevelOf(const OptionValues& values);

/// The way back to the files that the author has. None of a model: its level was made for it.
std::shared_ptr<const LevelSource> takeSource(OpenedLevel& opened);

/// To stderr, a line each.
void printDiagnostics(std::span<const Diagnostic> diagnostics);

/// The warning to print if no light reaches any surface; nullopt otherwise.
std::optional<std::string> warningIfDark(const Level& level, const BakedLight& light,
                                         const OptionValues& values);
/// Prints it to stderr.
void warnIfDark(const Level& level, const BakedLight& light, const OptionValues& values);

/// The mode of `--light`.
LightMode lightModeFrom(const OptionValues& values);

struct Bake {
  BakedLight light;
  BakeSettings settings;
  int threads;
  double seconds;
};

/// Bakes with the settings of `bakeSettingsFor(scene, values)`, and warns if all is dark. A
/// terminal shows the progress of a long bake. If stderr is no terminal, progress is written in the
/// given style.
tl::expected<Bake, std::string> bakeFor(const Scene& scene, const OptionValues& values,
                                        ProgressStyle styleWithoutTerminal = ProgressStyle::None);

/// Bakes with other settings, without a warning. With a memory, only light is baked that differs
/// from that of the bakes before.
Bake bakeWith(const Scene& scene, const BakeSettings& settings, const OptionValues& values,
              ProgressStyle styleWithoutTerminal, LightMemory* memory = nullptr);

/// The threads that bake.
int threadsFrom(const OptionValues& values);

/// The light to draw with: from the file that `--light-from` names, from the user's cache or, if it
/// is not there, baked and kept there.
tl::expected<BakedLight, std::string> lightFor(const Scene& scene, const OptionValues& values);

/// The same for one picture. If no cache keeps the light for later, only the light that the camera
/// sees is baked, and nothing is if `--light none` shows none.
tl::expected<BakedLight, std::string> lightInView(const Scene& scene, const Camera& camera,
                                                  const OptionValues& values);

/// The camera of the command line: that of `--camera`, else of `--shot`, else the player's. In
/// place of the player's, a model has one that looks at all of it.
tl::expected<Camera, std::string> cameraFor(const Scene& scene, const OptionValues& values,
                                            ImageSize standardSize);

}  // namespace hearth
