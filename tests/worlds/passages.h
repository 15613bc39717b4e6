#pragma once

#include <optional>
#include <span>
#include <vector>

#include "level/level.h"

namespace hearth::worlds {

/// From which sectors the player comes to which, with movers at their ends. Heights and steps
/// count; breadths and distances do not.
class Passages {
 public:
  /// The player climbs steps of `climb` metres. The level must outlive this.
  Passages(const Level& level, double climb);

  /// The fewest of the started movers that must stand at `to` for the player to pass; none where no
  /// ends of them let it pass. `isStarted` is by mover.
  std::optional<std::vector<std::size_t>> moversToPass(SectorId from, SectorId to,
                                                       const std::vector<bool>& isStarted) const;

 private:
  struct Ends {
    double floor;
    double ceiling;
  };

  Ends endsOf(SectorId id, std::span<const std::size_t> moved) const;
  bool fits(const Ends& from, const Ends& to) const;

  const Level& level_;
  double climb_;
  std::vector<std::vector<std::size_t>> moversOf_;  ///< by sector
};

}  // namespace hearth::worlds
