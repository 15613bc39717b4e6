#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

/// Random walks, with every promise of the walker held against the level after every tick.
namespace hearth::random_walks {

struct Report {
  std::uint64_t walks = 0;
  std::uint64_t ticks = 0;
  std::uint64_t failures = 0;
  std::string first;  ///< what failed first, and the walk that shows it
  /// Ticks in which ...
  std::uint64_t onGround = 0;
  std::uint64_t inFlight = 0;
  std::uint64_t crossings = 0;      ///< ... the sector changed
  std::uint64_t throughFlats = 0;   ///< ... the way led through a flat portal
  std::uint64_t besideOneWay = 0;   ///< ... solids could not be looked for
  std::uint64_t stuck = 0;          ///< starts without room, that are not walked
  std::uint64_t onThings = 0;       ///< ... the walker stood on a solid thing
  std::uint64_t againstThings = 0;  ///< ... or touched one's side
  std::uint64_t whileMoving = 0;    ///< ... something moved
  std::uint64_t turnedBack = 0;     ///< movers on the way to `to`, because of the walker
  std::uint64_t replays = 0;        ///< walks that were replayed

  Report& operator+=(const Report& other);
};

/// Of the walks through one level.
struct Effort {
  int walks;
  int ticks;  ///< of each walk
  int lines;  ///< out of the body's axis that must be in the air after every tick
};

/// Walks a random level of that seed, whose textures are in `folder`, from some of its views. So
/// many solid things stand in the level, or hang in its air, none of which the walker may be in.
Report walkRandomLevel(std::uint64_t seed, const std::filesystem::path& folder,
                       const Effort& effort, int solidThings = 0);

/// The same of a random level in which something moves, and which the walks start. Nothing where
/// the seed has none. Each walk is recorded, and replayed at few and at many frames a second.
Report walkMovingLevel(std::uint64_t seed, const std::filesystem::path& folder,
                       const Effort& effort);

struct WaysReport {
  int asked = 0;      ///< ways that the reference calls open
  int taken = 0;      ///< by a walker that was pushed that way for a second
  std::string first;  ///< that was not

  WaysReport& operator+=(const WaysReport& other);
};

/// From places of random walks through a random level: a plain search says which straight ways of
/// 0.3 m a body 5 mm stouter has, over level ground and steps up. It tries the cylinder every 2 cm,
/// in what `Solids` calls the air, and knows nothing of sliding or sweeping. A walker that is
/// pushed that way for a second must get at least 0.25 m ahead. This shows that nothing stops it
/// that is not there: neither seams, nor vertices, nor the walls of other storeys. It does not show
/// that it finds ways round corners, or over slopes and down steps, of which the search says
/// nothing.
WaysReport tryWays(std::uint64_t seed, const std::filesystem::path& folder, int places);

std::string inWords(const Report& report);

}  // namespace hearth::random_walks
