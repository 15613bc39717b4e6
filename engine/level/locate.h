#pragma once

#include "level/scene.h"

namespace hearth {

/// True when `p` lies in the outline of the sector, its border and the borders of its holes
/// included where there is air beside them. Exact.
bool contains(const Level& level, const Sector& sector, Vec2 p);

/// True when `p` lies in the air of the sector, walls, flats and slopes included, within
/// `slack` metres.
bool contains(const Scene& scene, const Sector& sector, Vec3 p, double slack);

/// `p`, or where it lies on (or within kPositionSlack outside) the walls, flats or slopes of the
/// sector, a point about kNudge inside them: from there no wall of the sector is seen edge-on.
Vec3 nudgedInside(const Scene& scene, const Sector& sector, Vec3 p);
/// Where the flats are as authored.
Vec3 nudgedInside(const Level& level, const Sector& sector, Vec3 p);

enum class Side { Upper, Lower };

/// The sector on one side of a flat portal that contains `p`; on a common border the first of
/// them; where rounding leaves `p` in none, the nearest.
SectorId across(const Level& level, const FlatPortal& flatPortal, Side to, Vec2 p);

}  // namespace hearth
