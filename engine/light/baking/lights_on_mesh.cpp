#include "light/baking/lights_on_mesh.h"

#include <algorithm>
#include <utility>

#include "math/box3.h"
#include "math/tolerance.h"

namespace hearth {

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
  for (const std::size_t i : visibilities.reach.reaching(box)) {
    Shaft shaft(scene);
    if (shaft.follow(visibilities.fine(i).shaftLight(), targets, nullptr) == TargetVisibility::Dark)
      continue;
    lights_.push_back(i);
    shafts_.push_back(std::move(shaft));
  }
}

const Shaft& LightsOnMesh::shaftFrom(std::size_t light) const {
  return shafts_[static_cast<std::size_t>(std::ranges::lower_bound(lights_, light) -
                                          lights_.begin())];
}

void LightsOnMesh::addSectorsTo(SectorSet& sectors) const {
  for (const Shaft& shaft : shafts_) shaft.addSectorsTo(sectors);
}

}  // namespace hearth
