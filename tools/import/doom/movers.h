#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/doom/findings.h"
#include "import/doom/heights.h"
#include "import/doom/line_types.h"
#include "import/doom/map.h"
#include "level/mover.h"

namespace hearth::doom {

/// How a flat moves, and where to.
struct Motion {
  int to;                      ///< map units
  double speed;                ///< metres a second
  std::optional<double> wait;  ///< seconds until it returns; none: it stays
  bool isLoop;

  friend auto operator<=>(const Motion&, const Motion&) = default;
};

/// Flats of a map's sectors that move together.
struct MapMover {
  std::string name;
  FlatPart part;
  int from;  ///< map units
  Motion motion;
  std::vector<std::uint32_t> sectors;
  std::vector<std::uint32_t> lines;  ///< that start it
};

/// What became of a line that does something in Doom.
struct LineFate {
  std::uint32_t line;
  std::optional<LineKind> kind;  ///< none: Doom has no such type
  std::string reason;            ///< why it is left out; empty: it starts movers

  bool isImported() const { return reason.empty(); }
};

/// What moves in a map.
struct MapMovers {
  std::vector<MapMover> movers;
  std::vector<LineFate> lines;
  Findings findings;  ///< of sectors that only some of their lines move

  std::set<std::uint32_t> starters() const;
  /// Leaves out the lines that no player can reach, the sectors without space, and what then has no
  /// lines or no sectors. `countWalls` says how many walls of the level a line is that starts
  /// movers: each names them all, so movers are also left out once these are too many.
  void keep(const std::function<std::size_t(std::uint32_t line)>& countWalls,
            const std::function<bool(std::uint32_t sector)>& isSpace);
};

/// From the heights with which the map begins; no ceiling lies below its floor.
MapMovers moversOf(const Map& map, const std::vector<Heights>& heights);

}  // namespace hearth::doom
