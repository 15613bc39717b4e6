#pragma once

#include <algorithm>
#include <variant>

#include "image/image.h"
#include "level/level.h"

/// What lines of walls and flats are drawn in.
namespace hearth {

inline constexpr Rgb kWallColor = {255, 255, 255};
inline constexpr Rgb kWayOnColor = {255, 160, 48};
inline constexpr Rgb kFlatPortalColor = {96, 224, 112};

/// Whether a segment has an opening.
inline bool leadsOn(const Segment& segment) {
  return std::ranges::any_of(segment.pieces, [](const WallPiece& piece) {
    return std::holds_alternative<Opening>(piece.content);
  });
}

inline Rgb colorOf(const Segment& segment) { return leadsOn(segment) ? kWayOnColor : kWallColor; }

/// Of the line in which a floor or ceiling meets walls.
inline Rgb colorOf(const Flat& flat) { return flat.flatPortal ? kFlatPortalColor : kWallColor; }

}  // namespace hearth
