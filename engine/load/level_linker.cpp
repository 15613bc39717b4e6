#include "load/level_linker.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "level/link_surfaces.h"
#include "level/mesh_sectors.h"
#include "level/thing_bodies.h"
#include "math/check.h"

namespace hearth {

namespace {

void addSurfacesAndGeometry(Linking& linking) {
  const std::vector<MissingTwin> portals = linkSurfaces(linking.level);
  CHECK(portals.empty(), "linkSegments makes such portals solid", portals.front().segment);
  std::vector<MissingTexture> textures;
  linking.geometry = deriveGeometry(linking.level, textures);
  reportMissingTextures(linking, textures, linking.report);
}

/// Sectors, walls and geometry. False if nothing is left of them after mistakes.
bool linkSectors(Linking& linking) {
  linking.outlines = makeOutlines(linking.description);
  validateOutlines(linking.report, linking.description, linking.outlines);
  validateReach(linking);
  linkFlats(linking);
  linkWalls(linking);
  linkSegments(linking);
  linkSlopes(linking);
  linkLegend(linking);
  linkMovers(linking);
  validateFlatPortals(linking);
  validateRings(linking);
  if (linking.level.segments.empty()) return false;
  addSurfacesAndGeometry(linking);
  linkSwitchTextures(linking);
  return true;
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

/// Once all have ids.
void nameTextures(Linking& linking) {
  for (const NamedTexture& texture : linking.textures.textures())
    linking.level.textures.push_back(texture.name);
}

/// A level that says nothing about light shows everything.
void lightFully(Linking& linking) {
  for (Sector& sector : linking.level.sectors) sector.light = 1;
  linking.report.warning(
      linking.description.place, "no lights and no \"light\": all is fully bright",
      "write a lights file, or give the level or its sectors a \"light\"", "no-light");
}

}  // namespace

std::optional<LinkedLevel> LevelLinker::link(const LevelDescription& description,
                                             const LightsDescription& lights,
                                             const std::vector<Image>* images) {
  const SectorNames names(description);
  TextureTable table;
  Linking linking{description, report_, names, table, {}, {}, {}, {}, {}, {}};
  linking.level.name = description.name.empty() ? place_.level.stem().string() : description.name;
  const bool isEmpty = !linkSectors(linking);
  LinkedLevel linked;
  if (!isEmpty) {
    linkSprites(linking);
    linked.models = linkMeshes(linking, place_);
  }
  if (!images)
    linked.textures =
        readTextures(report_, table, linking.scene(),
                     {place_.files, place_.level, description.textures}, place_.limits);
  if (isEmpty) return std::nullopt;
  nameTextures(linking);
  const std::vector<Image>& all = images ? *images : linked.textures.images;
  sizeSprites(linking.level, all);
  addThingSurfaces(linking.level, linking.geometry);
  validatePortals(linking);
  linkPositions(linking, lights);
  const bool isLoadedFirst = !images;
  if (isLoadedFirst && !description.movers.empty() && !report_.hasErrors()) {
    validateEnds(description, lights);
    if (!report_.hasErrors()) validateSteps(linking);
  }
  if (report_.hasErrors()) return std::nullopt;
  for (const Mesh& mesh : linking.level.meshes)
    linking.level.faceTrees.emplace_back(linking.level.facesOf(mesh));
  if (!addBodiesWithinLimit(linking) || !addMeshSectorsWithinLimit(linking)) return std::nullopt;
  if (saysNothingOfLight(description, lights)) lightFully(linking);

  linking.level.holes = holesOfMaskedMiddles(linking.scene(), all);
  for (const Image& image : all) linking.level.reflectances.push_back(reflectanceOf(image));
  linked.level = std::move(linking.level);
  linked.geometry = std::move(linking.geometry);
  linked.outlines = std::move(linking.outlines);
  linked.edgeOf = std::move(linking.edgeOf);
  return linked;
}

/// With floors at their other end, with ceilings there, and with both. What a sector needs depends
/// on its own two flats alone; `validateSteps` looks at what lies between two.
void LevelLinker::validateEnds(const LevelDescription& description,
                               const LightsDescription& lights) {
  std::vector<std::size_t> floors;
  std::vector<std::size_t> ceilings;
  for (std::size_t i = 0; i < description.movers.size(); ++i)
    (description.movers[i].part == FlatPart::Floor ? floors : ceilings).push_back(i);
  for (const auto& moved : {floors, ceilings})
    if (!moved.empty()) validateAt(description, lights, moved);
  if (floors.empty() || ceilings.empty() || report_.hasErrors()) return;
  floors.insert(floors.end(), ceilings.begin(), ceilings.end());
  validateAt(description, lights, floors);
}

void LevelLinker::validateAt(const LevelDescription& description, const LightsDescription& lights,
                             std::span<const std::size_t> moved) {
  std::vector<double> shares(description.movers.size());
  for (const std::size_t mover : moved) shares[mover] = 1;
  const LevelDescription at = descriptionAt(description, shares);
  Report found;
  const SectorNames names(at);
  TextureTable table;
  Linking linking{at, found, names, table, {}, {}, {}, {}, {}, {}};
  if (linkSectors(linking)) {
    linkSprites(linking);
    validateMeshPositions(linking);
    nameTextures(linking);
    linkPositions(linking, lights);
  }
  report_.addErrors(found, wordsFor(description.movers, moved));
}

}  // namespace hearth
