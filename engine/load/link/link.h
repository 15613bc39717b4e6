#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "files/file_source.h"
#include "level/level.h"
#include "level/scene.h"
#include "load/json/report.h"
#include "load/limits.h"
#include "load/link/outline.h"
#include "load/link/weld.h"
#include "load/read/description.h"
#include "load/textures.h"

namespace hearth {

/// Sectors by name.
class SectorNames {
 public:
  explicit SectorNames(const LevelDescription& description);

  bool has(const std::string& name) const { return ids_.contains(name); }
  /// Reports a name that no sector has. A name that several sectors have is already reported.
  std::optional<SectorId> link(Report& report, const NameReference& name) const;
  /// Reports the name for a wall of the sector `own`, and suggests one of the sectors `behind` the
  /// wall.
  void reportUnknown(Report& report, const NameReference& name, std::string_view own,
                     std::span<const std::string_view> behind) const;

 private:
  std::unordered_map<std::string, std::optional<SectorId>> ids_;  ///< none: several sectors
  std::vector<std::string_view> names_;
};

/// Movers by name.
class MoverNames {
 public:
  explicit MoverNames(const LevelDescription& description);

  /// Reports a name that no mover has.
  std::optional<std::size_t> link(Report& report, const NameReference& name) const;

 private:
  std::unordered_map<std::string_view, std::size_t> indices_;
  std::vector<std::string_view> names_;
};

/// A level on its way from names to ids.
struct Linking {
  const LevelDescription& description;
  Report& report;
  const SectorNames& names;
  TextureTable& textures;
  Level level;
  Geometry geometry;  ///< of the linked level
  Outlines outlines;
  std::vector<std::optional<Wall>> walls;  ///< by edge; none where the file's could not be linked
  std::vector<std::uint32_t> edgeOf;       ///< by segment
  /// By sector: whether a mistake in its heights or outline has been reported. Then
  /// missing textures in it are not reported.
  std::vector<bool> isDoubtful;

  Scene scene() const { return {level, geometry}; }

  const LoopDescription& describedLoop(const Edge& edge) const {
    return hearth::describedLoop(description, outlines, edge);
  }
  const WallDescription& describedWall(const Edge& edge) const {
    return describedLoop(edge).wall(edge.wallIndex);
  }
  const WallDescription& describedWall(SegmentId segment) const {
    return describedWall(outlines.edges[edgeOf[segment.index()]]);
  }
};

/// Where the models of a level lie, and how much of them is taken.
struct ModelPlace {
  const FileSource& files;
  const std::filesystem::path& level;  ///< its file
  const LoadLimits& limits;
};

// The steps of linking, in this order. Each reports what it cannot link and puts a stand-in in its
// place, so that the next ones and `linkSurfaces` find a level without holes.

/// Heights, textures, flat portals and light of all sectors.
void linkFlats(Linking& linking);
/// Links the names that walls lead to, and their textures.
void linkWalls(Linking& linking);
/// Links the textures of a grid's legend, so that those of unused entries must exist, too.
void linkLegend(Linking& linking);
/// Fits the outlines of linked sectors together and makes the level's loops and segments of them.
/// A portal that has no wall of the next sector behind it becomes solid.
void linkSegments(Linking& linking);
/// The planes of slopes, the origins of relative flats.
void linkSlopes(Linking& linking);

/// The description of the same level with its movers at `shares`, by index: their flats lie where
/// these take them, and it has no player.
LevelDescription descriptionAt(LevelDescription description, std::span<const double> shares);
/// What moves: its sectors, and the names of movers that walls give.
void linkMovers(Linking& linking);
/// The textures of walls that start movers, while these are on their way. After `linkSurfaces`.
void linkSwitchTextures(Linking& linking);
// What is asked of the linked level.

/// One-way portals, pairs that open different heights: warnings. After `deriveGeometry`.
void validatePortals(Linking& linking);
/// Members of one side that overlap, sides that cover different areas.
void validateFlatPortals(Linking& linking);
/// Sectors without height whose flat portals lead round in a ring.
void validateRings(Linking& linking);
/// Coordinates beyond kPreciseReach: a warning, once.
void validateReach(Linking& linking);
/// A light that lies on a surface of its sector: a warning. After `deriveGeometry`.
void validateLight(Report& report, const Scene& scene, Place place, const LightSource& light);
/// An emitter whose texture no surface of the level wears that can shine: a warning.
void validateEmitter(Report& report, const Level& level, Place place, std::string_view texture);
/// Reports surfaces that show without a texture, each at its cause.
void reportMissingTextures(const Linking& linking, std::span<const MissingTexture> missing,
                           Report& report);
/// Sectors of player, shots and lights. After `deriveGeometry`. A position is skipped if a
/// mistake has been reported about a sector that may contain it.
void linkPositions(Linking& linking, const LightsDescription& lights);
/// The sprites, their images and their sectors. After `deriveGeometry`.
void linkSprites(Linking& linking);
/// The meshes: their models, placed in the level, the images of these, and their sectors. After
/// `deriveGeometry`. Returns the files that were read; images not among them.
std::vector<std::filesystem::path> linkMeshes(Linking& linking, const ModelPlace& place);
/// Only asks whether the meshes lie in air.
void validateMeshPositions(Linking& linking);
/// How messages begin that hold while these movers, by index, are at `to`.
std::string wordsFor(std::span<const MoverDescription> movers, std::span<const std::size_t> moved);
/// Steps that show without a texture while some movers are at `to` and others are not. Leaves the
/// geometry as it was.
void validateSteps(Linking& linking);
/// Only the lights, and the settings of the bake.
void linkLights(Linking& linking, const LightsDescription& lights);
/// Whether neither level nor lights mention light: then all is fully bright.
bool saysNothingOfLight(const LevelDescription& description, const LightsDescription& lights);

}  // namespace hearth
