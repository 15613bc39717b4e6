#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "random_levels/places.h"

namespace hearth::random_levels {

enum class SpriteFacing { Camera, Angle, Flat };

struct RandomSprite {
  Place place;
  bool saysHeight = true;  ///< else it stands on the floor
  bool namesSector = true;
  SpriteFacing facing = SpriteFacing::Camera;
  double angle = 0;
  std::vector<std::string> images;
  std::optional<std::array<double, 2>> size;    ///< m
  std::optional<std::array<double, 2>> offset;  ///< m
  bool isBright = false;
};

/// One to six sprites, most of them where the views look; notes what is special about them. None
/// lies in the plane of a view's eye, where it would be seen edge-on.
std::vector<RandomSprite> makeSprites(Random& random, const Model& model,
                                      const std::vector<RandomView>& views,
                                      std::set<Feature>& features);

}  // namespace hearth::random_levels
