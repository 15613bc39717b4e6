#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "load/json/document.h"
#include "load/link/outline.h"
#include "load/load.h"
#include "load/read/description.h"

namespace hearth {

/// The way back from a loaded level to its files: the description of each part, and its place.
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
  LevelSource source;  ///< incomplete if no level was loaded
};

/// `loadLevel`, for a caller that reports on the level's files as well. Holds all of their text.
/// With `unsavedLights` the lights file is taken to hold this text, even if there is none yet.
SourcedResult loadLevelWithSource(const std::filesystem::path& file, const LoadLimits& limits = {},
                                  const std::optional<std::string>& unsavedLights = {},
                                  const FileSource& files = DiskFiles());

/// Reads only the lights file again. If no other file has changed, the result is that of loading,
/// in much less time; its diagnostics are about that file alone. `source` is that of `loaded`, and
/// becomes that of the result if there is a level. None if the level has no such file (any more),
/// or if a level that is fully bright without lights gets its first light or loses its last.
/// `unsavedLights` as above.
std::optional<LoadResult> reloadLights(const LoadedLevel& loaded, LevelSource& source,
                                       const LoadLimits& limits = {},
                                       const std::optional<std::string>& unsavedLights = {},
                                       const FileSource& files = DiskFiles());

/// The level with its movers at other shares (0..1, by index into Level::movers): what loads where
/// the flats are authored at these heights. Reads models again, and shares the images of
/// `authored`, whose source this is. Has the player only while its eye lies in air.
LoadResult levelAt(const LoadedLevel& authored, const LevelSource& source,
                   std::span<const double> shares, const LoadLimits& limits = {},
                   const FileSource& files = DiskFiles());

}  // namespace hearth
