#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "settings/settings.h"

namespace hearth {

/// Settings to measure.
struct Trial {
  /// The settings that differ from the level's own, as options; empty if none does.
  std::string options;
  BakeSettings bake;
  DrawSettings draw;
};

/// The level's own settings first, then the qualities, then each approximation by itself, then
/// combinations of those that cost most time. Each once; `values` hold for all.
tl::expected<std::vector<Trial>, std::string> trialsFor(const Scene& scene,
                                                        const OptionValues& values);

}  // namespace hearth
