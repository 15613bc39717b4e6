#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "measure/machine.h"
#include "measure/tradeoff/measure_trials.h"

namespace hearth {

/// What settings cost on a level, and how far off they are.
struct TradeoffReport {
  std::string level;  ///< its path
  Machine machine;
  int bakeThreads = 1;
  PictureSize truthSize{};
  PictureSize frameSize{};
  std::vector<Measured> trials;  ///< the level's own settings first
  /// By trial. Of those that are drawn as accurately as the level's own: on the front of seconds to
  /// bake against the RMS of light.
  std::vector<bool> onBakeFront;
  /// Of those that are baked like the level's own: on the front of time for a frame against the RMS
  /// of pictures.
  std::vector<bool> onFrameFront;
};

/// With both fronts found.
TradeoffReport reportOf(TradeoffReport measured);

/// `bake`, `frame`, `both` or nothing.
std::string_view frontName(const TradeoffReport& report, std::size_t trial);
std::string_view nameOf(const Trial& trial);

/// For people.
std::string tableOf(const TradeoffReport& report);
/// For programs: a line for each trial, after one of names (RFC 4180).
std::string csvOf(const TradeoffReport& report);

}  // namespace hearth
