#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "measure/machine.h"
#include "measure/tradeoff/measure_trials.h"

namespace hearth {

/// The costs and errors of settings on a level.
struct TradeoffReport {
  std::string level;  ///< its path
  Machine machine;
  int bakeThreads = 1;
  ImageSize truthSize{};
  ImageSize frameSize{};
  std::vector<TrialResult> trials;  ///< the level's own settings first
  /// For each trial: whether it is Pareto-optimal in seconds to bake and RMS of light, among trials
  /// that are drawn as accurately as the level's own.
  std::vector<bool> onBakeFront;
  /// The same in time for a frame and RMS of pictures, among trials that are baked like the level's
  /// own.
  std::vector<bool> onFrameFront;
};

/// The report with both fronts.
TradeoffReport reportOf(TradeoffReport measured);

/// `bake`, `frame`, `both` or nothing.
std::string_view frontName(const TradeoffReport& report, std::size_t trial);
std::string_view nameOf(const Trial& trial);

/// A table for the terminal.
std::string tableOf(const TradeoffReport& report);
/// CSV: a row of names, then one row for each trial (RFC 4180).
std::string csvOf(const TradeoffReport& report);

}  // namespace hearth
