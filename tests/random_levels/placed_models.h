#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "random_levels/obj_models.h"
#include "random_levels/sprites.h"

namespace hearth::random_levels {

/// A thing that is a mesh.
struct PlacedModel {
  Place place;
  bool saysHeight = true;  ///< else it stands on the floor
  bool namesSector = true;
  std::size_t model = 0;                 ///< number, of objModels()
  std::array<double, 3> scale{1, 1, 1};  ///< along x, y and z of a level, before it is turned
  double angle = 0;                      ///< degrees
  std::string texture;                   ///< of models without materials
  bool isTwoSided = false;
  bool castsShadow = true;
  std::size_t spritesBefore = 0;  ///< that the file lists before it
};

/// One to four of them, most where the views look; notes what is special about them. None has a
/// face in whose plane a view's eye lies.
std::vector<PlacedModel> placeModels(Random& random, const Model& model,
                                     const std::vector<RandomView>& views,
                                     const std::vector<RandomSprite>& sprites,
                                     std::set<Feature>& features);

}  // namespace hearth::random_levels
