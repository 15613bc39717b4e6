#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "light/gather/area_lights.h"
#include "light/gather/blocked_slopes.h"

namespace hearth {

/// The part of a face in the plane of a slice. Along a straight part 1 / distance is linear in the
/// slope, as it is across a picture: depth buffers rely on the same.
struct FaceCut {
  SlopeRange slopes;
  double nearFrom;  ///< 1 / metres on the map from the start, at `slopes.from` ...
  double nearTo;    ///< ... and at `slopes.to`
  std::optional<AreaLights::Place> light;  ///< that its face gives towards the start

  double nearAt(double slope) const {
    return std::lerp(nearFrom, nearTo, (slope - slopes.from) / (slopes.to - slopes.from));
  }
};

/// Where `a` hides `b`. Of two in one place `a` does if `isFirst`.
inline SlopeRange whereHidden(const FaceCut& a, const FaceCut& b, bool isFirst) {
  const SlopeRange both = common(a.slopes, b.slopes);
  if (both.isEmpty()) return both;
  const double atFrom = a.nearAt(both.from) - b.nearAt(both.from);
  const double atTo = a.nearAt(both.to) - b.nearAt(both.to);
  if (atFrom == 0 && atTo == 0) return isFirst ? both : SlopeRange{both.from, both.from};
  if (atFrom >= 0 && atTo >= 0) return both;
  if (atFrom <= 0 && atTo <= 0) return {both.from, both.from};
  const double crossing = std::lerp(both.from, both.to, atFrom / (atFrom - atTo));
  return atFrom > 0 ? SlopeRange{both.from, crossing} : SlopeRange{crossing, both.to};
}

/// Calls `visit(slopes, light)` where a face that shines is seen: where no other hides it.
template <typename Visit>
void forEachShining(const std::vector<FaceCut>& cuts, BlockedSlopes& hidden, Visit&& visit) {
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (!cuts[i].light) continue;
    hidden.clear();
    for (std::size_t k = 0; k < cuts.size(); ++k)
      if (k != i) hidden.add(whereHidden(cuts[k], cuts[i], k < i));
    hidden.forEachFree(cuts[i].slopes, [&](SlopeRange seen) { visit(seen, *cuts[i].light); });
  }
}

}  // namespace hearth
