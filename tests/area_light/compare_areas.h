#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "area_light/area_tally.h"
#include "load/load.h"

namespace hearth::area_light {

/// Which areas shine in a comparison.
enum class Areas {
  Sky,       ///< that of the level, if it has one
  Emitters,  ///< surfaces that wear every other texture
  Bounces  ///< what surfaces reflect, three times, of points of light and of a sky if there is one
};

/// Bakes a level with the light of areas alone, and holds texels of each surface, points of
/// meshes and sprites against truth. A level that has a sky and no light of it gets some. `name`
/// says which level it was in the note of the worst place.
AreaTally compareAreas(LoadedLevel loaded, Areas areas, std::string_view name);

/// The same for the random level of `seed`. `folder` holds the textures of random levels; the level
/// is written there for the time.
AreaTally compareRandomLevel(std::uint64_t seed, Areas areas, const std::filesystem::path& folder);

}  // namespace hearth::area_light
