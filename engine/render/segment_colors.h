#pragma once

#include <algorithm>
#include <variant>

#include "image/image.h"
#include "level/scene.h"

/// The colours in which edges of walls, flats and meshes are drawn.
namespace hearth {

inline constexpr Rgb kWallColor = {255, 255, 255};
inline constexpr Rgb kWayOnColor = {255, 160, 48};
inline constexpr Rgb kFlatPortalColor = {96, 224, 112};
inline constexpr Rgb kMeshColor = {144, 160, 255};

/// Whether a segment has an opening.
inline bool leadsOn(const Scene& scene, const Segment& segment) {
  return std::ranges::any_of(scene.piecesOf(segment), [](const WallPiece& piece) {
    return std::holds_alternative<Opening>(piece.content);
  });
}

inline Rgb colorOf(const Scene& scene, const Segment& segment) {
  return leadsOn(scene, segment) ? kWayOnColor : kWallColor;
}

/// The colour of the line where a floor or ceiling meets walls.
inline Rgb colorOf(const Flat& flat) { return flat.flatPortal ? kFlatPortalColor : kWallColor; }

}  // namespace hearth
