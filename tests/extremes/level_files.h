#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "load/load.h"

namespace hearth::extremes {

/// A level and its lights as authors write them, to be changed and loaded.
struct LevelFiles {
  std::string level;               ///< JSON
  std::string lights;              ///< JSON, always an object with "lights" and "bake"
  std::filesystem::path textures;  ///< folder of its images
};

/// The level of a seed of tests/random_levels, its lengths rounded to 2^-20 m: then it can be
/// moved and scaled by whole numbers and powers of two without rounding one coordinate.
LevelFiles randomFiles(std::uint64_t seed);

/// The same with suns that are points. Of a small level a penumbra is as narrow as the micrometre
/// by which samples on an edge are moved inside.
LevelFiles withPointSuns(LevelFiles files);

/// The same without the light of the sky, which is interpolated over each surface.
LevelFiles withoutSky(LevelFiles files);

/// A level from text in which single quotes stand for double ones.
LevelFiles filesOf(std::string_view level, std::string_view lights = "[]");

/// Stops the test program with the loader's messages when the level has a mistake.
LoadedLevel load(const LevelFiles& files);

/// As above, with whatever messages there are.
LoadResult tryLoad(const LevelFiles& files);

}  // namespace hearth::extremes
