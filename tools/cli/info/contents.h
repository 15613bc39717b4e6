#pragma once

#include <cstdint>

#include "cli/info/format_features.h"
#include "cli/info/light_report.h"
#include "inputs/inputs.h"
#include "load/load.h"
#include "load/source.h"

namespace hearth {

/// What a level holds, and what drawing it needs.
struct Contents {
  std::int64_t loops = 0;
  std::int64_t textureBytes = 0;  ///< as frames read them
  BakeSettings settings;          ///< of the light
  LightReport light;
  FeatureCounts features;
};

Contents contentsOf(const LoadedLevel& loaded, const LevelSource& source, const Bake& bake);

}  // namespace hearth
