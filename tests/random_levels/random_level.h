#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "random_levels/feature.h"

/// Random levels that are valid by construction: for tests and comparisons that must hold for
/// every level, not only for the ones that somebody thought of.
namespace hearth {

/// A camera inside a sector: metres, degrees, pixels.
struct RandomView {
  std::string name;
  std::string sector;
  double x = 0;
  double y = 0;
  double z = 0;
  double angle = 0;
  double pitch = 0;
  double fov = 90;
  int width = 160;
  int height = 100;
};

struct RandomLevel {
  std::string name;               // "level_<seed>": the stem of both files
  std::string levelJson;          // <name>.json; its images and models are in "textures" beside it
  std::string lightsJson;         // <name>.lights.json
  std::vector<RandomView> views;  // at least four; also the level's shots
  std::set<Feature> features;     // what the level holds
};

/// The same seed gives the same bytes on every machine. A level has 3 to 25 sectors, is at most
/// 30 m across, and has lights of no size.
RandomLevel makeRandomLevel(std::uint64_t seed);

struct RandomTexture {
  std::string_view name;
  int width = 0;
  int height = 0;
};

/// All images that random levels name. Odd sizes, and no two texels of one colour, so that a wrong
/// row or column shows.
inline constexpr std::array<RandomTexture, 8> kRandomLevelTextures{{{"dot", 1, 1},
                                                                    {"seven", 7, 5},
                                                                    {"square", 16, 16},
                                                                    {"tall", 12, 100},
                                                                    {"wide", 64, 32},
                                                                    {"odd", 33, 17},
                                                                    {"strip", 1, 40},
                                                                    {"large", 128, 96}}};

/// Those that hang in openings and that most sprites wear: about half of their texels are holes.
inline constexpr std::array<RandomTexture, 3> kRandomLevelMiddles{
    {{"bars", 8, 8}, {"lattice", 11, 7}, {"veil", 5, 24}}};

/// Writes `<folder>/<name>.png` for each, and beside them the models that meshes show, as OBJ files
/// with their materials; makes the folder. The error names the file.
tl::expected<void, std::string> writeRandomLevelTextures(const std::filesystem::path& folder);

/// Writes both files of the level into `folder`, and neither textures nor models.
tl::expected<void, std::string> writeRandomLevel(const std::filesystem::path& folder,
                                                 const RandomLevel& level);

}  // namespace hearth
