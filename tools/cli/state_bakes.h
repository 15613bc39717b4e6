#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "inputs/inputs.h"
#include "level/bake_settings.h"
#include "light/rebake.h"
#include "model/open_level.h"
#include "settings/options.h"

namespace hearth {

/// What the states of a level's movers took, apart from the level as authored.
struct StateFigures {
  std::size_t movers = 0;
  std::size_t count = 0;      ///< of states
  double seconds = 0;         ///< to bake them
  std::int64_t bytes = 0;     ///< of their light
  std::size_t keptBytes = 0;  ///< from bake to bake
};

/// Bakes a level in the states that its movers can have, one after the other: those that
/// `statesToKeep` lists. From state to state, only light changes that a mover is in the way of.
class StateBakes {
 public:
  /// With `areSaved` bytes() has all of it. The rest must outlive it.
  StateBakes(const OpenedLevel& opened, const BakeSettings& settings, const OptionValues& values,
             bool areSaved);

  Bake bakeAuthored();
  /// After the level as authored. Returns the error of a state that cannot be loaded.
  std::optional<std::string> bakeOthers();

  StateFigures figures() const;
  /// A saved bake with all states.
  const std::string& bytes() const { return bytes_; }

 private:
  const LoadedLevel& authored() const { return *opened_.result.loaded; }
  Bake add(const Scene& scene);

  const OpenedLevel& opened_;
  BakeSettings settings_;
  const OptionValues& values_;
  bool areSaved_;
  std::vector<std::vector<double>> states_;  ///< shares of the movers
  LightMemory memory_;
  StateFigures figures_;
  std::string bytes_;
};

}  // namespace hearth
