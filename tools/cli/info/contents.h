#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cli/info/format_features.h"
#include "cli/info/light_report.h"
#include "inputs/inputs.h"
#include "load/load.h"
#include "load/source.h"
#include "measure/light_difference.h"

namespace hearth {

/// A mover, and where it stands.
struct MoverContents {
  Mover mover;
  double from;  ///< its height at share 0
  double share;
  bool hasSwitch;  ///< some wall starts it
};

/// What a level holds, and what drawing it needs.
struct Contents {
  std::int64_t loops = 0;
  std::int64_t textureBytes = 0;  ///< as frames read them
  BakeSettings settings;          ///< of the light
  LightReport light;
  FeatureCounts features;
  std::vector<MoverContents> movers;     ///< in the order of the file
  std::optional<LightDifference> blend;  ///< of the light shown while some are between their ends,
                                         ///< from a bake at these heights
};

std::vector<MoverContents> moverContents(const LoadedLevel& authored,
                                         std::span<const double> shares);

/// All but its movers.
Contents contentsOf(const LoadedLevel& loaded, const LevelSource& source, const Bake& bake);

}  // namespace hearth
