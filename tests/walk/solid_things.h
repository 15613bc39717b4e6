#pragma once

#include <array>
#include <vector>

#include "load/load.h"
#include "random_levels/random_level.h"
#include "walk/body.h"
#include "walk/walker.h"

/// Solid things that random walks meet, known in the plainest way.
namespace hearth::random_walks {

/// Upright over a triangle, whose corners may be in line or at one place, grown by a radius.
struct SolidThing {
  SectorId sector;
  Vec3 position;  ///< in the sector, in the triangle and at its bottom
  std::array<Vec2, 3> corners;
  double radius;
  double zTop;
};

/// Metres between the thing's side and a player's, seen from above; negative where they overlap.
double apart(const SolidThing& thing, Vec2 feet, double radius);

/// Whether a walker that starts there would be in the thing.
bool isIn(const SolidThing& thing, const Walker& walker, const Body& body);

/// Adds so many at most, near the level's views, on the floor or above it. Every other one is a
/// sprite, the others are meshes of a triangle that may stand upright.
std::vector<SolidThing> addSolidThings(LoadedLevel& loaded, const RandomLevel& random, int count);

}  // namespace hearth::random_walks
