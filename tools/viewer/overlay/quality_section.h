#pragma once

#include <string>
#include <string_view>

#include "level/level.h"
#include "render/draw_settings.h"
#include "settings/mover_light.h"
#include "settings/options.h"

namespace hearth {

/// How a walk is lit and drawn, as the overlay lets choose it.
struct QualityChoice {
  OptionValues options = {};  ///< of the command line, of which those of bakes and frames change
  double fov = 90;            ///< degrees, horizontal
  double frameCap = 0;        ///< frames per second; 0: none
};

/// What the choice has come to in the level at hand.
struct EffectiveSettings {
  BakeSettings authored;  ///< the file's own
  BakeSettings bake;
  DrawSettings draw;
  MoverLightSettings movers = {};
  bool canBake = false;  ///< else the light is as it is
};

/// Selects a quality and clears all single settings.
void chooseQuality(OptionValues& options, std::string_view name);

/// What all settings together were measured to cost, and how far off they are.
std::string bakeInWords(const EffectiveSettings& effective, const OptionValues& options);
std::string framesInWords(const EffectiveSettings& effective);

/// A section of the overlay. Returns whether options have been chosen anew.
bool showQuality(const EffectiveSettings& effective, QualityChoice& choice);

}  // namespace hearth
