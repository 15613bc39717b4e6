#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "agreement/tally.h"

namespace hearth::movers {

struct MoverTally {
  std::int64_t levels = 0;  ///< in which something moves
  std::int64_t movers = 0;
  std::int64_t states = 0;       ///< all movers at ends
  std::int64_t pictures = 0;     ///< of these, each compared with that of a level authored so
  std::int64_t between = 0;      ///< levels with movers between their ends, compared with truth
  agreement::Tally truth;        ///< of these
  double squares = 0;            ///< of the levels by which light between ends differs from a bake
  std::int64_t lightTexels = 0;  ///< that were compared
  std::int64_t otherGrids = 0;   ///< levels whose light between ends has grids of its own
  std::int64_t failed = 0;
  std::string firstFailure;

  MoverTally& operator+=(const MoverTally& other);
};

/// Compares the random level of a seed with itself: at all ends of its movers with levels that are
/// authored so, to the byte, also light that is found with that of the ends before, kept in a
/// random amount of memory; and at random shares with truth. `folder` holds the textures of random
/// levels.
MoverTally compareRandomMovers(std::uint64_t seed, const std::filesystem::path& folder);

/// In a few lines.
std::string inWords(const MoverTally& tally);

}  // namespace hearth::movers
