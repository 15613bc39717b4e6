#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "random_levels/feature.h"
#include "random_levels/model.h"
#include "random_levels/random_level.h"

namespace hearth::random_levels {

/// A point in the air of a sector.
struct Place {
  SectorIndex sector = 0;
  Vec3 position;
};

/// Degrees, as in a lights file.
struct RandomSpot {
  double angle = 0;
  double pitch = 0;
  double inner = 0;
  double outer = 0;
};

struct RandomLight {
  Place place;
  bool namesSector = true;
  double intensity = 255;
  double falloff = 0;
  std::vector<std::array<double, 2>> curve;  ///< when not empty, instead of these: m, levels
  std::string color;                         ///< "#rrggbb"; none when empty
  std::optional<RandomSpot> spot;
};

/// Finds places for lights and cameras, and notes what is special about them.
class Places {
 public:
  Places(Random& random, const Model& model, std::set<Feature>& features);

  std::vector<RandomLight> lights(std::size_t count);
  std::vector<RandomView> views(std::size_t count);

 private:
  Place anywhere();
  std::optional<Place> inSector(SectorIndex s);
  std::optional<Place> onPortalLine();
  std::optional<Place> inLineWithWall();
  std::optional<Place> outsideSky(bool isAbove);
  RandomLight light();
  std::optional<Place> at(SectorIndex s, Vec2 p);
  RandomView lookFrom(const Place& place);

  Random& random_;
  const Model& model_;
  std::set<Feature>& features_;
};

}  // namespace hearth::random_levels
