#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/info/light_report.h"
#include "load/load.h"

namespace hearth {

/// How many parts of a kind could use a feature of the engine in the level, and how many do.
struct EngineFeatureUse {
  std::string_view name;  ///< stable: scripts read it
  std::int64_t used;
  std::int64_t of;
  std::string_view rest;  ///< why the others do not
};

/// The features that cost only levels that use them.
std::vector<EngineFeatureUse> engineFeatureUses(const LoadedLevel& loaded,
                                                const LightReport& light);

}  // namespace hearth
