#pragma once

#include <string>
#include <vector>

#include "random_levels/placed_models.h"
#include "random_levels/places.h"
#include "random_levels/sprites.h"
#include "random_levels/suns.h"

namespace hearth::random_levels {

/// How the files are spelled where the format leaves a choice.
struct Spelling {
  bool hasSectorArray = false;
  bool hasLoopArrays = false;
  bool namesLightsFile = true;
  bool hasLightArray = false;  ///< then the bake is the format's default
  bool omitsDefaults = false;  ///< heights that are the format's defaults
  std::optional<double> levelLight;
  double texel = 0.25;  ///< m
  int samples = 1;      ///< per texel
  bool lambert = false;
};

std::string levelJson(const Model& model, const std::string& name,
                      const std::vector<RandomView>& views,
                      const std::vector<RandomSprite>& sprites,
                      const std::vector<PlacedModel>& models, const Spelling& spelling);
std::string lightsJson(const Model& model, const std::vector<RandomLight>& lights,
                       const FarLights& farLights, const Spelling& spelling);

}  // namespace hearth::random_levels
