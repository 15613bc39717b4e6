#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "level/level.h"

namespace hearth {

struct Geometry;

/// Each body counts once in every sector that it reaches into.
inline constexpr std::size_t kMaxBodies = 1'000'000;

/// Sets `Level::bodies` and `Level::bodiesBySector`: of each solid thing a body is in its sector,
/// in each sector to which an opening leads that it crosses or touches, and so on. Openings that
/// face away from the thing's position do not count. The body of a sprite is a cylinder, that of a
/// mesh a prism over the convex hull of its faces on the map. If that makes more than kMaxBodies,
/// returns the thing (an index) with which it does; the level must not be used then.
std::optional<std::uint32_t> addBodies(Level& level, const Geometry& geometry);

/// Makes the body of a sprite begin at its position.
void stand(ThingBody& body, const Sprite& sprite);

}  // namespace hearth
