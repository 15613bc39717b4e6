#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "load/source.h"
#include "model/model_figures.h"

namespace hearth {

/// Whether a file is taken for a model rather than a level: its name ends in `.obj`, whatever the
/// case.
bool isModel(const std::filesystem::path& file);

/// A level, or a model alone in the open, with its source.
struct OpenedLevel {
  LoadResult result;
  LevelSource source;                 ///< of a model: texts that were made for it
  std::optional<ModelFigures> model;  ///< if it is a model that was loaded
};

/// Loads a level as `loadLevelWithSource` does, or a model. Messages about a model name its files
/// and their lines. `unsavedLights` are those of a level.
OpenedLevel openLevel(const std::filesystem::path& file, const LoadLimits& limits = {},
                      const std::optional<std::string>& unsavedLights = {},
                      const FileSource& files = DiskFiles());

}  // namespace hearth
