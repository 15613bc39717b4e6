#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "route.h"
#include "walk/walker.h"

namespace hearth::test {

/// Where a walk is to lead.
struct Aim {
  std::vector<Spot> spots;  ///< at which it ends
  /// Whether it ends with this tick, from one walker to the next.
  std::function<bool(const Walker& before, const Walker& after)> isReached;
};

/// Inputs with which a walker comes from the player's start to an aim, in a level that moves. The
/// heights tell which movers must be started on the way, one after the other. To each of them, and
/// then to the aim, A* searches a way with the body itself: it runs, uses switches and waits. With
/// `leap` > 0 metres it also jumps, and steps count that are higher by that than those that the
/// body climbs: so it leaps over pits of that depth. The same for the same level. The error says
/// how far it came.
tl::expected<std::vector<WalkInput>, std::string> wayThroughMovers(const Scene& authored,
                                                                   const Walker& start, double leap,
                                                                   const Aim& aim);

}  // namespace hearth::test
