#pragma once

#include "level/scene.h"

namespace hearth {

/// Whether `p` lies inside the outline of the sector. A point on the border, or on the border of a
/// hole, counts if there is air beside it. Exact.
bool contains(const Level& level, const Sector& sector, Vec2 p);

/// Whether `p` lies in the air of the sector, or within `slack` metres of it. The walls, flats and
/// slopes around the air count as air.
bool contains(const Scene& scene, const Sector& sector, Vec3 p, double slack);

/// A point inside the sector from which no wall of the sector is seen edge-on. If `p` lies on the
/// walls, flats or slopes of the sector, or within kPositionSlack outside them, the point is about
/// kNudge inside them, and farther where walls meet at sharp angles; else, or if no such point is
/// found, it is `p`.
Vec3 nudgedInside(const Scene& scene, const Sector& sector, Vec3 p);
/// The same, with the flats at their authored heights.
Vec3 nudgedInside(const Level& level, const Sector& sector, Vec3 p);

/// The sector on side `to` of a flat portal that contains `p`. On a common border of several, it is
/// the first of them. If rounding leaves `p` in none, it is the nearest.
SectorId sectorAcross(const Level& level, const FlatPortal& flatPortal, FlatPortalSide to, Vec2 p);

}  // namespace hearth
