#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "load/load.h"
#include "load/source.h"
#include "measure/frame_times.h"
#include "measure/light_difference.h"
#include "settings/settings.h"

namespace hearth {

/// What a number of stages costs, and how far off light between them is.
struct MoverTrial {
  int stages = 0;
  std::size_t bakes = 0;       ///< that the ways of all movers take
  double seconds = 0;          ///< of these
  double cost = 1;             ///< a multiple of the time without stages
  LightDifference light = {};  ///< from bakes at the heights between
};

struct MoverTrialSetup {
  int threads = 1;  ///< of bakes
  int repeats = 3;
  Clock clock;  ///< must advance between two calls
};

/// Moves each mover of a level alone from end to end, the others as authored. Light is compared at
/// kMoverPlaces shares, evenly between the ends and next to them. The first of `stages` is 0, with
/// which the others are compared.
inline constexpr int kMoverPlaces = 16;
tl::expected<std::vector<MoverTrial>, std::string> measureMovers(const LoadedLevel& authored,
                                                                 const LevelSource& source,
                                                                 const BakeSettings& settings,
                                                                 const std::vector<int>& stages,
                                                                 const MoverTrialSetup& setup);

/// A table for the terminal, and CSV: a row of names, then one row for each trial.
std::string tableOf(const std::vector<MoverTrial>& trials);
std::string csvOf(const std::vector<MoverTrial>& trials);

}  // namespace hearth
