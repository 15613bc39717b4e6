#include "light/baking/lights_on_mesh.h"

#include <algorithm>
#include <vector>

#include "math/box3.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Adds the shaft between a light and targets, unless it is dark. Returns whether it did.
template <typename AnyShaft, typename From>
bool addShaft(const Scene& scene, const From& from, const ShaftTargets& targets,
              std::vector<AnyShaft>& shafts) {
  shafts.emplace_back(scene);
  if (shafts.back().follow(from, targets, nullptr) != TargetVisibility::Dark) return true;
  shafts.pop_back();
  return false;
}

}  // namespace

Box3 boxOf(const Level& level, const LitMesh& lit) {
  Box3 box = level.faceTrees[level.meshIndexOf(lit.surface)].box();
  for (const LitMesh::Patch& patch : lit.patches) {
    const TargetBox grid = boxOf(patch.surface);
    for (const Vec3 corner : grid.corners()) box.add(corner);
  }
  return box;
}

TargetBox boxOf(const LitSurface& patch) {
  const TexelRect& rect = patch.texels;
  TargetBox box;
  for (const int i : {rect.i0, rect.i0 + rect.width})
    for (const int j : {rect.j0, rect.j0 + rect.height})
      box.storage[box.count++] = patch.toWorld({1.0 * i, 1.0 * j});
  box.normal = patch.normal;
  return box;
}

LightsOnMesh::LightsOnMesh(const Scene& scene, const LightVisibilities& visibilities,
                           const LitMesh& lit, std::span<const SectorId> sectors) {
  const Box3 box = boxOf(scene.level(), lit);
  const ShaftTargets targets{TargetBox::around(box), sectors};
  for (const std::size_t i : visibilities.reach.reaching(box))
    if (mayShineOn(scene, visibilities, i, targets)) lights_.push_back(i);
}

/// Keeps the shaft of a light that may.
bool LightsOnMesh::mayShineOn(const Scene& scene, const LightVisibilities& visibilities,
                              std::size_t light, const ShaftTargets& targets) {
  if (scene.lights()[light].isArea()) return true;
  if (const SunVisibility* sun = visibilities.sun(light))
    return addShaft(scene, sun->cone(), targets, skyShafts_);
  return addShaft(scene, visibilities.fine(light).shaftLight(), targets, shafts_);
}

std::size_t LightsOnMesh::placeOf(std::size_t light) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(lights_, light) - lights_.begin());
}

void LightsOnMesh::addSectorsTo(SectorSet& sectors) const {
  for (const Shaft& shaft : shafts_) shaft.addSectorsTo(sectors);
  for (const SkyShaft& shaft : skyShafts_) shaft.addSectorsTo(sectors);
}

}  // namespace hearth
