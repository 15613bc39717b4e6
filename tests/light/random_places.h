#pragma once

#include <functional>

#include "level/scene.h"
#include "light/lit_surface.h"

namespace hearth::test {

/// A point from which light could be seen: on the border of the air of a sector.
struct RandomPlace {
  const Scene& scene;
  Vec3 point;
  SectorId sector;
  Vec3 normal;  ///< of the surface there
};

/// Asks at one place of each lit surface of 60 random levels, or until a test has failed. `change`
/// is made to each level before.
void forEachRandomPlace(const std::function<void(Level&)>& change,
                        const std::function<void(const RandomPlace&)>& ask);

}  // namespace hearth::test
