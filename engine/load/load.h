#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/file_source.h"
#include "image/shared_images.h"
#include "level/scene.h"
#include "load/diagnostic.h"
#include "load/limits.h"
#include "load/positions.h"

namespace hearth {

struct LoadedLevel {
  Level level;
  Geometry geometry;      ///< of the level as authored
  SharedImages textures;  ///< by TextureId; one black pixel where no surface wears it
  std::filesystem::path path;
  std::filesystem::path lights;  ///< file of its lights: where one belongs if there is none
  /// All that was read: the level first, then its lights if it has any, then models with their
  /// materials, then the images. A program that watches these knows when to load again.
  std::vector<std::filesystem::path> files;
  /// Images among the files that a surface wears. Of the others only the header is read.
  std::size_t decodedImages = 0;
  /// Of the level file's text, by std::hash: a program that edits it knows if it has changed since.
  std::size_t textHash = 0;

  Scene scene() const { return {level, geometry}; }
};

struct LoadResult {
  std::optional<LoadedLevel> loaded;    ///< none after an error
  std::vector<Diagnostic> diagnostics;  ///< errors and warnings, in the order of the files
};

/// Where the lights of a level lie that does not name their file.
std::filesystem::path lightsBeside(const std::filesystem::path& level);

/// Reads a level with its lights, models and textures. All mistakes are reported together, each at
/// its place; there is no level unless there is none. Up to four threads read the images, one for
/// each core. levels/README.md says what the files hold.
LoadResult loadLevel(const std::filesystem::path& file, const LoadLimits& limits = {},
                     const FileSource& files = DiskFiles());

}  // namespace hearth
