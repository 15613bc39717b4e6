#include "light/light_fingerprints.h"

#include <cstddef>
#include <set>
#include <span>
#include <variant>

#include "light/gather/area_lights.h"
#include "light/gather/small_areas.h"
#include "light/geometry_hash.h"
#include "math/hash.h"

namespace hearth {

namespace {

class Printer {
 public:
  Printer(const Scene& scene, const LitSurfaces& surfaces)
      : scene_(scene),
        surfaces_(surfaces),
        areas_(scene),
        shining_(hashesOfShining(scene.level(), areas_)) {
    for (const Sector& sector : scene.level().sectors) names_.push_back(hashOf(sector.name));
    for (const TexelHoles& texture : scene.level().holes) holes_.push_back(hashOf(texture));
    for (const Mesh& mesh : scene.level().meshes) meshes_.push_back(hashOf(mesh));
    for (const Sector& sector : scene.level().sectors) outlines_.push_back(outlineOf(sector));
    for (std::size_t i = 0; i < surfaces.size(); ++i) faces_.push_back(faceOf(SurfaceId(i)));
  }

  LightFingerprints print() const {
    LightFingerprints prints;
    for (std::size_t i = 0; i < scene_.level().sectors.size(); ++i)
      prints.sectors.push_back(printOf(SectorId(i)));
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      prints.surfaces.push_back(printOf(SurfaceId(i)));
    prints.meshes = printsOfMeshes();
    prints.lights = printsOfLights(prints);
    return prints;
  }

 private:
  static std::uint64_t hashOf(const std::string& text) {
    Hash hash;
    hash.addText(text);
    return hash.value();
  }

  static std::uint64_t hashOf(const TexelHoles& holes) {
    Hash hash;
    addHoles(hash, holes);
    return hash.value();
  }

  std::uint64_t hashOf(const Mesh& mesh) const {
    Hash hash;
    addMesh(hash, scene_.level(), mesh);
    addShining(hash, scene_.level(), areas_, mesh);
    return hash.value();
  }

  /// Those that stop light in a sector.
  void addMeshes(Hash& hash, SectorId sector) const {
    for (const MeshInSector& at : scene_.level().meshesIn(sector))
      if (scene_.level().meshes[at.mesh].castsShadow) hash.addWhole(meshes_[at.mesh]);
  }

  /// A sector without what it leads to, except the names.
  std::uint64_t outlineOf(const Sector& sector) const {
    const PartNumbers numbers{
        [this](SectorId id) { return names_[id.index()]; },
        [this](FlatPortalId id) { return hashOf(scene_[id].name); },
        [this](TextureId id) { return holes_[id.index()]; },
    };
    Hash hash;
    hash.addText(sector.name);
    addGeometry(hash, scene_, sector, numbers);
    if (!shining_.empty()) hash.addWhole(shining_[sector.id.index()]);
    return hash.value();
  }

  std::uint64_t printOf(SectorId id) const {
    const Sector& sector = scene_[id];
    Hash hash;
    hash.addWhole(outlines_[id.index()]);
    for (const Segment& segment : scene_.segmentsOf(sector)) addOpenings(hash, segment);
    for (const SectorId next : neighboursOf(sector)) hash.addWhole(outlines_[next.index()]);
    addMeshes(hash, id);
    return hash.value();
  }

  void addOpenings(Hash& hash, const Segment& segment) const {
    const std::span<const LightOpening> openings = scene_.lightOpeningsOf(segment);
    hash.addWhole(openings.size());
    for (const LightOpening& opening : openings) {
      hash.addReal(opening.zBottom);
      hash.addReal(opening.zTop);
      hash.addWhole(names_[opening.next.index()]);
      hash.addWhole(opening.twin.value - scene_[opening.next].firstSegment.value);
    }
  }

  /// All sectors that walls and flats of a sector lead to, each once.
  std::set<SectorId> neighboursOf(const Sector& sector) const {
    std::set<SectorId> next;
    const auto addPortal = [&](const auto& kind) {
      if (const Portal* portal = std::get_if<Portal>(&kind)) next.insert(portal->next);
    };
    for (const Segment& segment : scene_.segmentsOf(sector)) {
      addPortal(segment.wall);
      if (const Stack* stack = std::get_if<Stack>(&segment.wall))
        for (const SubWall& subWall : stack->subWalls) addPortal(subWall.kind);
    }
    if (sector.floor.flatPortal) {
      const auto& lower = scene_[*sector.floor.flatPortal].lower;
      next.insert(lower.begin(), lower.end());
    }
    if (sector.ceiling.flatPortal) {
      const auto& upper = scene_[*sector.ceiling.flatPortal].upper;
      next.insert(upper.begin(), upper.end());
    }
    return next;
  }

  /// A surface without what continues it, and the meshes in which samples of it may lie.
  std::uint64_t faceOf(SurfaceId id) const {
    const auto& surface = surfaces_[id.index()];
    if (!surface) return 0;
    Hash hash;
    hash.addWhole(names_[scene_[id].sector.index()]);
    addMeshes(hash, scene_[id].sector);
    const TexelGrid& grid = surface->grid;
    for (const Vec3 v : {grid.origin, grid.axisS, grid.axisT, surface->anchor, surface->normal})
      hash.addPoint(v);
    hash.addReal(grid.texel);
    const std::vector<std::vector<Vec2>> polygons = surface->outline.loops();
    hash.addWhole(polygons.size());
    for (const std::vector<Vec2>& polygon : polygons) {
      hash.addWhole(polygon.size());
      for (const Vec2 p : polygon) hash.addPoint(p);
    }
    return hash.value();
  }

  std::uint64_t printOf(SurfaceId id) const {
    const auto& surface = surfaces_[id.index()];
    if (!surface) return 0;
    Hash hash;
    hash.addWhole(faces_[id.index()]);
    for (const Continuation& next : surface->continuations) {
      hash.addWhole(faces_[next.surface.index()]);
      hash.addPoint(next.edge0);
      hash.addPoint(next.edge1);
    }
    return hash.value();
  }

  /// With the sectors that they are in: where sectors overlap, meshes at one place differ in these.
  std::vector<std::uint64_t> printsOfMeshes() const {
    std::vector<Hash> hashes(meshes_.size());
    for (std::size_t i = 0; i < meshes_.size(); ++i) hashes[i].addWhole(meshes_[i]);
    for (const MeshInSector& at : scene_.level().meshesBySector)
      hashes[at.mesh].addWhole(names_[at.sector.index()]);
    std::vector<std::uint64_t> prints;
    for (const Hash& hash : hashes) prints.push_back(hash.value());
    return prints;
  }

  /// Areas are found together: where one is looked for closely, all are. So each has the prints of
  /// all of them, and of the surfaces that are looked for; of all parts where light bounces.
  std::vector<std::uint64_t> printsOfLights(const LightFingerprints& parts) const {
    std::vector<std::uint64_t> prints;
    for (const LightSource& light : scene_.lights()) prints.push_back(printOf(light));
    Hash all;
    for (const std::size_t area : areas_.lights()) all.addWhole(prints[area]);
    SmallAreas(scene_, areas_).addTo(all);
    if (areas_.bounced()) {
      for (const auto& of : {prints, parts.sectors, parts.surfaces, parts.meshes})
        for (const std::uint64_t print : of) all.addWhole(print);
      addReflectances(all, scene_.level());
    }
    for (const std::size_t area : areas_.lights()) {
      Hash hash = all;
      hash.addWhole(prints[area]);
      prints[area] = hash.value();
    }
    return prints;
  }

  std::uint64_t printOf(const LightSource& light) const {
    Hash hash;
    addLight(hash, light, names_[light.sector.index()]);
    return hash.value();
  }

  Scene scene_;
  const LitSurfaces& surfaces_;
  AreaLights areas_;
  std::vector<std::uint64_t> shining_;   ///< by SectorId; empty where no surfaces can shine
  std::vector<std::uint64_t> names_;     ///< by SectorId
  std::vector<std::uint64_t> holes_;     ///< by TextureId
  std::vector<std::uint64_t> meshes_;    ///< hashes, in the level's order
  std::vector<std::uint64_t> outlines_;  ///< by SectorId
  std::vector<std::uint64_t> faces_;     ///< by SurfaceId
};

}  // namespace

LightFingerprints lightFingerprints(const Scene& scene, const LitSurfaces& surfaces) {
  return Printer(scene, surfaces).print();
}

}  // namespace hearth
