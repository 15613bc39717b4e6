#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "import/doom/findings.h"
#include "import/doom/map.h"
#include "math/vec.h"

namespace hearth::doom {

/// Metres in a unit of a map: lines lie at exact places.
inline constexpr double kUnit = 1.0 / 32;

/// Where a place of a map lies in a level, whose y grows down.
inline Vec2 placeOf(int x, int y) { return {x * kUnit, -y * kUnit}; }

/// Doom's angles turn left from east, Hearth's right. Degrees, 0 to 359.
inline int angleOf(int degrees) { return ((-degrees % 360) + 360) % 360; }

/// One face of a piece of a line.
struct Face {
  std::uint32_t side;
  std::uint32_t line;
  double along;     ///< metres from the line's left end, seen from this side, to the piece's
  bool isTwoSided;  ///< the line, as its author meant it
};

/// A part of a line that meets others at its ends only. Front first: that is the side on which a
/// wall from the first point to the second is seen.
struct Piece {
  std::array<std::uint32_t, 2> points;
  std::array<std::optional<Face>, 2> faces;
};

struct Pieces {
  std::vector<Vec2> points;   ///< metres; no two alike
  std::vector<Piece> pieces;  ///< no two between the same points
};

/// Cuts the lines of a map wherever one meets another. Lines between the same points become one.
/// One that misses a point by so little that levels could not tell is bent to it. One of the
/// `starters` that would divide nothing, because it ends within a sector, has pieces all round a
/// sliver beside it. The error is one sentence.
tl::expected<Pieces, std::string> piecesOf(const Map& map, const std::set<std::uint32_t>& starters,
                                           Findings& findings);

}  // namespace hearth::doom
