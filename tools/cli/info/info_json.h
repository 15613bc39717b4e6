#pragma once

#include <nlohmann/json_fwd.hpp>

#include "cli/info/contents.h"
#include "light/bakery.h"

namespace hearth {

/// The counts of what there is; in an order that does not change.
nlohmann::ordered_json infoToJson(const LoadedLevel& loaded, const Contents& contents);

/// The texel grids that a saved bake must have: engine/light/saved_bake.md describes the keys.
nlohmann::ordered_json texelGridsToJson(const Scene& scene, const BakedLight& light);

}  // namespace hearth
