#pragma once

#include <span>
#include <string_view>

#include "level/level.h"
#include "render/draw_settings.h"
#include "settings/options.h"

namespace hearth {

/// Settings of a bake, relative to those of the level's author, who knows how large the rooms are.
struct BakeQuality {
  double texelScale;     ///< factor on the level's texel size
  bool adaptiveSamples;  ///< as many samples as edges of shadows need; else as the level says
  int softSamples;
  double gatherError;

  BakeSettings appliedTo(const BakeSettings& authored) const;
};

/// Settings that go together. `hearth tradeoff` measures what each costs and how far off it is.
struct Quality {
  std::string_view name;
  BakeQuality bake;
  DrawSettings draw;
};

/// From the one that is soonest done to the one that is nearest to truth.
std::span<const Quality> qualities();

/// Null where none has the name.
const Quality* qualityNamed(std::string_view name);

/// The one that holds if none is asked for.
inline constexpr std::string_view kDefaultQuality = "normal";
/// What the options ask for.
const Quality& qualityFrom(const OptionValues& values);

}  // namespace hearth
