#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "level/bake_settings.h"
#include "load/load.h"
#include "measure/frame_times.h"
#include "measure/machine.h"

namespace hearth {

/// A setting of a bake that is tried; all others are those of the level.
struct AreaSetting {
  enum class Of { GatherError, Bounces };

  Of of;
  double value;
};

/// What a setting costs, and how far off light of areas is with it: that of the sky, of surfaces
/// that shine, and that bounces.
struct AreaTrial {
  AreaSetting setting;
  double cost = 1;          ///< a multiple of the time with the settings of the level
  double seconds = 0;       ///< of the whole bake
  std::int64_t slices = 0;  ///< that its areas took
  std::size_t places = 0;   ///< that were compared with truth
  std::size_t far = 0;      ///< of those, the ones with a channel more than kVisible levels off
  double rms = 0;   ///< levels, of the channel that is farthest off, rounded as lightmaps are
  double most = 0;  ///< levels

  static constexpr double kVisible = 4;
};

/// What a level's trials are of.
struct AreaReport {
  std::string level;  ///< its path
  Machine machine;
  int threads = 1;  ///< of bakes
  int bounces = 0;
  std::vector<AreaTrial> trials;
};

struct AreaTrialSetup {
  int threads = 1;  ///< of bakes, and of truth
  int repeats = 3;
  std::size_t places = 1000;
  Clock clock;  ///< must advance between two calls
  std::function<void(std::size_t done)> onProgress;
};

/// Takes all lights that are areas out of a level, and lets none bounce. Whether that changes it.
bool takeOutAreas(Level& level);

/// Bakes a level with each of some settings, in turn with its own, and holds the light of areas at
/// the same texels against truth, of which as much bounces as the level says. That is the light of
/// the bake less that of one without areas; where lightmaps are at their brightest it is not known,
/// and is not compared. Texels have one sample, and balls shine from their middles: so truth is a
/// point's, and is found in time.
std::vector<AreaTrial> measureAreas(const LoadedLevel& loaded, const BakeSettings& settings,
                                    std::span<const AreaSetting> tried,
                                    const AreaTrialSetup& setup);

/// The option and its value.
std::string nameOf(const AreaTrial& trial);
/// Of places, how many are far off.
double farShareOf(const AreaTrial& trial);

/// A table for the terminal, and CSV: a row of names, then one row for each trial.
std::string tableOf(const std::vector<AreaTrial>& trials);
std::string csvOf(const std::vector<AreaTrial>& trials);

}  // namespace hearth
