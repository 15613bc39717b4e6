#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "agreement/tally.h"
#include "load/load.h"

namespace hearth::agreement {

/// Draws and bakes a level and holds every pixel of its first `shots` shots against truth. `name`
/// says which level it was in the note of a miss. Lights with a radius are compared as points, and
/// `samples: "auto"` as one sample: truth would take 20,000 rays for a ball at every texel, and as
/// many samples as "auto" is better than. tests/light holds both against truth.
Tally compareLevel(const LoadedLevel& loaded, std::string_view name, std::size_t shots);

/// The same for four shots of the random level of `seed`. `folder` holds the textures of random
/// levels; the level is written there for the time.
Tally compareRandomLevel(std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace hearth::agreement
