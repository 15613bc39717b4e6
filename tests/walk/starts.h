#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "load/load.h"
#include "random_levels/random_level.h"
#include "walk/walker.h"
#include "walk_tests/solids.h"

namespace hearth::random_walks {

std::optional<SectorId> sectorNamed(const Level& level, const std::string& name);

/// None where it does not load. Nothing in it is solid but the level itself.
std::optional<LoadedLevel> loadRandom(const RandomLevel& random,
                                      const std::filesystem::path& folder);

/// A walker in a view of the level; none where it would have no room.
std::optional<Walker> standIn(const Scene& scene, const Solids& solids, const RandomView& view);

}  // namespace hearth::random_walks
