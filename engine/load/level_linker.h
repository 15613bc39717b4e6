#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "load/link/link.h"
#include "load/load.h"
#include "load/read/description.h"
#include "load/textures.h"

namespace hearth {

/// A level, and the way back to its description.
struct LinkedLevel {
  Level level;
  Geometry geometry;
  TextureFiles textures;                      ///< none where images were given
  std::vector<std::filesystem::path> models;  ///< with their materials
  Outlines outlines;
  std::vector<std::uint32_t> edgeOf;  ///< by segment
};

/// From descriptions to a checked level.
class LevelLinker {
 public:
  /// `place` is that of the level's file. Mistakes go to `report`.
  LevelLinker(Report& report, const ModelPlace& place) : report_(report), place_(place) {}

  /// None after a mistake. Reads models, and images unless `images` has them.
  std::optional<LinkedLevel> link(const LevelDescription& description,
                                  const LightsDescription& lights,
                                  const std::vector<Image>* images = nullptr);

 private:
  void validateEnds(const LevelDescription& description, const LightsDescription& lights);
  void validateAt(const LevelDescription& description, const LightsDescription& lights,
                  std::span<const std::size_t> moved);

  Report& report_;
  ModelPlace place_;
};

}  // namespace hearth
