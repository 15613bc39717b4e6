#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "load/json/document.h"
#include "load/link/outline.h"
#include "load/load.h"
#include "load/read/description.h"

namespace hearth {

/// The way back from a loaded level to its files: what they say of each of its parts, and where.
struct LevelSource {
  std::vector<Document> documents;    ///< by Place::document
  LevelDescription level;             ///< sectors and shots are those of the level, by index
  LightsDescription lights;           ///< likewise
  Outlines outlines;                  ///< welded: their points are the ends of segments
  std::vector<std::uint32_t> edgeOf;  ///< by segment

  const Edge& edge(SegmentId segment) const { return outlines.edges[edgeOf[segment.index()]]; }
  const WallDescription& wall(SegmentId segment) const;
  /// Of an end of an edge: of its x in the file.
  Place vertexPlace(const Edge& edge, std::uint32_t vertex) const;
};

struct SourcedResult {
  LoadResult result;
  LevelSource source;  ///< incomplete where no level was loaded
};

/// `loadLevel`, for a caller that reports on the level's files as well. Holds all of their text.
/// With `unsavedLights` the lights file is taken to hold this text, even if there is none yet.
SourcedResult loadLevelWithSource(const std::filesystem::path& file, const LoadLimits& limits = {},
                                  const std::optional<std::string>& unsavedLights = {},
                                  const FileSource& files = DiskFiles());

/// The level with what its lights file says now: what loading gives where no other file has
/// changed, and much sooner; it tells of that file alone. `source` is that of `loaded`, and becomes
/// that of the result if this has a level. None where the level has no such file (any more), or its
/// first or last light comes or goes of a level that else is fully bright. `unsavedLights` as
/// above.
std::optional<LoadResult> reloadLights(const LoadedLevel& loaded, LevelSource& source,
                                       const LoadLimits& limits = {},
                                       const std::optional<std::string>& unsavedLights = {},
                                       const FileSource& files = DiskFiles());

}  // namespace hearth
