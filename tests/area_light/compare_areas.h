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

// A level is baked with the light of areas alone, and texels, small faces of meshes and sprites are
// held against truth. One that has a sky and no light of it gets some.

/// `count` texels of surfaces and patches of meshes, each as likely as any other. `name` says which
/// level it was in the note of the worst place.
AreaTally compareTexels(LoadedLevel loaded, Areas areas, std::string_view name, int count,
                        int threads);

/// Some texels of every surface and patch, small faces and all sprites of the random level of
/// `seed`. `folder` holds the textures of random levels; the level is written there for the time.
AreaTally compareRandomLevel(std::uint64_t seed, Areas areas, const std::filesystem::path& folder,
                             double gatherError = BakeSettings{}.gatherError);

}  // namespace hearth::area_light
