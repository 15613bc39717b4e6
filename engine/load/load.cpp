#include "load/load.h"

#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <string>

#include "level/link_surfaces.h"
#include "level/mesh_sectors.h"
#include "level/thing_bodies.h"
#include "load/grid/expand_grid.h"
#include "load/json/read_document.h"
#include "load/link/link.h"
#include "load/read/read.h"
#include "load/source.h"
#include "math/check.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

class Loader {
 public:
  Loader(const fs::path& file, const LoadLimits& limits,
         const std::optional<std::string>& unsavedLights, const FileSource& files)
      : file_(file), limits_(limits), unsavedLights_(unsavedLights), from_(files) {
    source_.documents.reserve(2);  // values point into them
  }

  SourcedResult load() {
    LoadResult result;
    if (const std::optional<JsonValue> root = rootOf(file_, {})) {
      source_.level = readLevel(report_, *root, limits_);
      if (source_.level.grid) expandGrid(report_, limits_.vertices, source_.level);
      source_.lights = readLightsOf(source_.level);
      result.loaded = link(source_.level, source_.lights);
    }
    result.diagnostics = report_.resolve(source_.documents);
    return {std::move(result), std::move(source_)};
  }

 private:
  std::optional<JsonValue> rootOf(const fs::path& path, const std::optional<std::string>& unsaved);
  LightsDescription readLightsOf(const LevelDescription& description);
  std::optional<LoadedLevel> link(const LevelDescription& description,
                                  const LightsDescription& lights);
  void lightFully(Linking& linking) const;

  const fs::path& file_;
  const LoadLimits& limits_;
  std::optional<std::string> unsavedLights_;
  const FileSource& from_;
  Report report_;
  LevelSource source_;
  std::vector<fs::path> files_;
  fs::path lights_;
};

/// The root of a file; reported when there is none.
std::optional<JsonValue> Loader::rootOf(const fs::path& path,
                                        const std::optional<std::string>& unsaved) {
  const auto index = static_cast<std::uint32_t>(source_.documents.size());
  Document& document = source_.documents.emplace_back();
  files_.push_back(path);
  if (!readDocument(from_, path, unsaved, limits_, document, index, report_)) return std::nullopt;
  return JsonValue(document, index, 0);
}

LightsDescription Loader::readLightsOf(const LevelDescription& description) {
  lights_ =
      description.lights ? file_.parent_path() / description.lights->name : lightsBeside(file_);
  if (!unsavedLights_ && from_.kindOf(lights_) == FileKind::None) {
    if (description.lights)
      report_.error(description.lights->place, fmt::format("there is no file {}", lights_.string()),
                    "correct the path, which is relative to the level file");
    return {};
  }
  const std::optional<JsonValue> root = rootOf(lights_, unsavedLights_);
  return root ? readLights(report_, *root, limits_) : LightsDescription{};
}

/// A level that says nothing about light shows everything.
void Loader::lightFully(Linking& linking) const {
  for (Sector& sector : linking.level.sectors) sector.light = 1;
  linking.report.warning(
      linking.description.place, "no lights and no \"light\": all is fully bright",
      "write a lights file, or give the level or its sectors a \"light\"", "no-light");
}

void addSurfacesAndGeometry(Linking& linking) {
  const std::vector<MissingTwin> portals = linkSurfaces(linking.level);
  CHECK(portals.empty(), "linkSegments makes such portals solid", portals.front().segment);
  std::vector<MissingTexture> textures;
  linking.geometry = deriveGeometry(linking.level, textures);
  reportMissingTextures(linking, textures);
}

Place placeOfThing(const LevelDescription& description, std::uint32_t thing) {
  for (const SpriteDescription& sprite : description.sprites)
    if (sprite.sprite.thing == thing) return sprite.place;
  for (const MeshDescription& mesh : description.meshes)
    if (mesh.mesh.thing == thing) return mesh.place;
  return description.place;
}

/// Solid things, once all are linked.
bool addBodiesWithinLimit(Linking& linking) {
  const std::optional<std::uint32_t> excess = addBodies(linking.level, linking.geometry);
  if (!excess) return true;
  linking.report.error(
      placeOfThing(linking.description, *excess),
      fmt::format("solid things reach into more than {} sectors, with this one", kMaxBodies),
      "lower their \"radius\" or \"scale\", or give meshes \"solid\": false");
  return false;
}

/// Where meshes are, once all are linked.
bool addMeshSectorsWithinLimit(Linking& linking) {
  const std::optional<std::size_t> excess = addMeshSectors(linking.level, linking.geometry);
  if (!excess) return true;
  linking.report.error(linking.description.meshes[*excess].place,
                       fmt::format("meshes reach into more than {} sectors, with this one and "
                                   "those before it",
                                   kMaxMeshesInSectors),
                       "lower their \"scale\"");
  return false;
}

std::optional<LoadedLevel> Loader::link(const LevelDescription& description,
                                        const LightsDescription& lights) {
  if (description.sectors.empty() || !description.isReadable) return std::nullopt;
  const SectorNames names(description);
  TextureTable table;
  Linking linking{description, report_, names, table, {}, {}, {}, {}, {}, {}};
  linking.level.name = description.name.empty() ? file_.stem().string() : description.name;
  linking.outlines = makeOutlines(description);
  validateOutlines(report_, description, linking.outlines);
  validateReach(linking);
  linkFlats(linking);
  linkWalls(linking);
  linkSegments(linking);
  linkSlopes(linking);
  linkLegend(linking);
  validateFlatPortals(linking);
  validateRings(linking);
  const bool isEmpty = linking.level.segments.empty();
  if (!isEmpty) {
    addSurfacesAndGeometry(linking);
    linkSprites(linking);
    for (fs::path& file : linkMeshes(linking, {from_, file_, limits_}))
      files_.push_back(std::move(file));
  }
  TextureFiles textures =
      readTextures(report_, table, linking.scene(), {from_, file_, description.textures}, limits_);
  if (isEmpty) return std::nullopt;
  sizeSprites(linking.level, textures.images);
  addThingSurfaces(linking.level, linking.geometry);
  validatePortals(linking);
  linkPositions(linking, lights);
  if (report_.hasErrors()) return std::nullopt;
  for (const Mesh& mesh : linking.level.meshes)
    linking.level.faceTrees.emplace_back(linking.level.facesOf(mesh));
  if (!addBodiesWithinLimit(linking) || !addMeshSectorsWithinLimit(linking)) return std::nullopt;
  if (saysNothingOfLight(description, lights)) lightFully(linking);

  for (const NamedTexture& texture : table.textures())
    linking.level.textures.push_back(texture.name);
  linking.level.holes = holesOfMaskedMiddles(linking.scene(), textures.images);
  files_.insert(files_.end(), textures.files.begin(), textures.files.end());
  source_.outlines = std::move(linking.outlines);
  source_.edgeOf = std::move(linking.edgeOf);
  return LoadedLevel{std::move(linking.level),
                     std::move(linking.geometry),
                     SharedImages(std::move(textures.images)),
                     file_,
                     lights_,
                     files_,
                     textures.decoded,
                     std::hash<std::string>{}(source_.documents.front().text)};
}

}  // namespace

fs::path lightsBeside(const fs::path& level) {
  return level.parent_path() / (level.stem().string() + ".lights.json");
}

LoadResult loadLevel(const fs::path& file, const LoadLimits& limits, const FileSource& files) {
  return Loader(file, limits, {}, files).load().result;
}

SourcedResult loadLevelWithSource(const fs::path& file, const LoadLimits& limits,
                                  const std::optional<std::string>& unsavedLights,
                                  const FileSource& files) {
  return Loader(file, limits, unsavedLights, files).load();
}

}  // namespace hearth
