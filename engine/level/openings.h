#pragma once

#include <algorithm>
#include <variant>

#include "level/scene.h"

namespace hearth {

/// The heights at which a portal changes from lower step to opening to upper step:
/// [zBottom, zLowerTop) lower, [zLowerTop, zUpperBottom) open, [zUpperBottom, zTop) upper.
struct PortalHeights {
  double zBottom;
  double zLowerTop;
  double zUpperBottom;
  double zTop;
};

/// A portal that reaches from `zBottom` to `zTop` on this side, seen against the flats of the next
/// sector. Where these leave no opening, all below its floor is lower step and the rest upper.
constexpr PortalHeights portalHeights(double zBottom, double zTop, double nextFloor,
                                      double nextCeiling) {
  const double zLowerTop = std::clamp(nextFloor, zBottom, zTop);
  return {zBottom, zLowerTop, std::clamp(nextCeiling, zLowerTop, zTop), zTop};
}

/// Where the air of both sides of an opening meets, `fraction` of the way from the p0 of the near
/// segment to its p1. Below zBottom stands the near slope or the far one's sidewall, likewise
/// above.
struct OpeningSpan {
  double zNearBottom;  ///< the opening's piece, clipped by the near sector's air
  double zBottom;      ///< and by the next sector's air
  double zTop;
  double zNearTop;
};

constexpr OpeningSpan openingSpan(const WallPiece& piece, AirColumn near, AirColumn far) {
  const double low = std::max(piece.zBottom, near.zBottom);
  const double high = std::max(low, std::min(piece.zTop, near.zTop));
  const double bottom = std::clamp(far.zBottom, low, high);
  return {low, bottom, std::clamp(far.zTop, bottom, high), high};
}

/// Calls `onSurface(SurfaceId, zBottom, zTop)` and `onOpening(const Opening&, zBottom, zTop)` for
/// all that a segment holds above one point of it, bottom to top, clipped to the sector's air.
/// Empty spans are left out; the others meet exactly.
template <typename OnSurface, typename OnOpening>
void visitWallColumn(const Scene& scene, const Segment& segment, double fraction,
                     OnSurface&& onSurface, OnOpening&& onOpening) {
  const AirColumn near = scene.airAt(segment, fraction);
  for (const WallPiece& piece : scene.piecesOf(segment)) {
    if (const SurfaceId* surface = std::get_if<SurfaceId>(&piece.content)) {
      const double low = std::max(piece.zBottom, near.zBottom);
      const double high = std::min(piece.zTop, near.zTop);
      if (low < high) onSurface(*surface, low, high);
      continue;
    }
    const Opening& opening = std::get<Opening>(piece.content);
    const OpeningSpan span =
        openingSpan(piece, near, scene.airAt(scene[opening.twin], 1 - fraction));
    // Where a slope leaves no more than rounding of a sidewall, there is none: the opening goes on.
    const double zBottom = opening.floorSidewall ? span.zBottom : span.zNearBottom;
    const double zTop = opening.ceilingSidewall ? span.zTop : span.zNearTop;
    if (span.zNearBottom < zBottom) onSurface(*opening.floorSidewall, span.zNearBottom, zBottom);
    if (zBottom < zTop) onOpening(opening, zBottom, zTop);
    if (zTop < span.zNearTop) onSurface(*opening.ceilingSidewall, zTop, span.zNearTop);
  }
}

}  // namespace hearth
