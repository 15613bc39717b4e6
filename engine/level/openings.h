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

/// The heights of a portal that reaches from `zBottom` to `zTop` on this side, given the flats of
/// the next sector. If the flats leave no opening, everything below the next floor is lower step,
/// and the rest is upper step.
constexpr PortalHeights portalHeights(double zBottom, double zTop, double nextFloor,
                                      double nextCeiling) {
  const double zLowerTop = std::clamp(nextFloor, zBottom, zTop);
  return {zBottom, zLowerTop, std::clamp(nextCeiling, zLowerTop, zTop), zTop};
}

/// The heights of an opening at one point of its segment. The air of both sides meets between
/// zBottom and zTop. The sidewall of the far slope stands between zNearBottom and zBottom, and the
/// near slope lies below zNearBottom. The same holds above zTop.
struct OpeningSpan {
  double zNearBottom;  ///< bottom of the piece, clipped to the near sector's air
  double zBottom;      ///< the same, clipped to the next sector's air too
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
/// every surface and opening of a segment at one point of it, `fraction` of the way from p0 to p1.
/// Goes from bottom to top. Heights are clipped to the sector's air. Empty spans are left out; the
/// others meet exactly.
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
    // A sidewall that is nowhere higher than rounding does not exist: the opening takes its place.
    const double zBottom = opening.floorSidewall ? span.zBottom : span.zNearBottom;
    const double zTop = opening.ceilingSidewall ? span.zTop : span.zNearTop;
    if (span.zNearBottom < zBottom) onSurface(*opening.floorSidewall, span.zNearBottom, zBottom);
    if (zBottom < zTop) onOpening(opening, zBottom, zTop);
    if (zTop < span.zNearTop) onSurface(*opening.ceilingSidewall, zTop, span.zNearTop);
  }
}

}  // namespace hearth
