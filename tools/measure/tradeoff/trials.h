#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "settings/settings.h"

namespace hearth {

/// Settings that are tried.
struct Trial {
  /// Those that are not the level's own, as options; empty where all are.
  std::string options;
  BakeSettings bake;
  DrawSettings draw;
};

/// The level's own settings first, then the qualities, then each approximation by itself, then
/// combinations of those that most time goes into. None twice; `values` hold for all.
tl::expected<std::vector<Trial>, std::string> trialsFor(const Scene& scene,
                                                        const OptionValues& values);

}  // namespace hearth
