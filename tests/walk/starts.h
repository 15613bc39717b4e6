#pragma once

#include <filesystem>
#include <optional>

#include "load/load.h"
#include "random_levels/random_level.h"
#include "walk/walker.h"
#include "walk_tests/solids.h"

namespace hearth::random_walks {

/// None where it does not load.
std::optional<LoadedLevel> loadRandom(const RandomLevel& random,
                                      const std::filesystem::path& folder);

/// A walker in a view of the level; none where it would have no room.
std::optional<Walker> standIn(const Scene& scene, const Solids& solids, const RandomView& view);

}  // namespace hearth::random_walks
