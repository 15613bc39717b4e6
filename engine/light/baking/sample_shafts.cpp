#include "light/baking/sample_shafts.h"

#include <algorithm>
#include <cstdint>

#include "math/box3.h"

namespace hearth {

Shaft& SampleShafts::shaftAt(std::size_t depth) {
  while (shafts_.size() <= depth) shafts_.emplace_back(rays_.scene());
  return shafts_[depth];
}

/// Within that of less depth, if there is one.
TargetVisibility SampleShafts::follow(std::size_t depth, std::size_t light, const ShaftLight& from,
                                      const ShaftTargets& targets) {
  Shaft& shaft = shaftAt(depth);
  if (depth > 0) return shaft.follow(from, targets, &shafts_[depth - 1]);
  const TargetVisibility outcome = shaft.follow(from, targets, nullptr);
  if (SectorSet* met = rays_.enteredSectors(light)) shaft.addSectorsTo(*met);
  return outcome;
}

std::vector<std::uint32_t> SampleShafts::meshesToMeet(std::size_t light,
                                                      const ShaftTargets& targets) const {
  const Level& level = rays_.scene().level();
  std::vector<std::uint32_t> meshes;
  if (level.meshes.empty()) return meshes;
  const ShaftLight& from = rays_.visibility(light).shaftLight();
  const ShaftHull hull(from.center, from.radius, targets.box);
  Box3 around = Box3{from.center, from.center}.grownBy(from.radius);
  for (const Vec3 corner : targets.box.corners()) around.add(corner);
  around = around.grownBy(hull.margin());
  // Of many meshes most are elsewhere, and their boxes tell so sooner than the hull.
  for (std::uint32_t i = 0; i < level.meshes.size(); ++i)
    if (level.faceTrees[i].box().meets(around) && hull.mayMeet(level, i)) meshes.push_back(i);
  return meshes;
}

bool SampleShafts::mayMeetMesh(std::size_t light, const ShaftTargets& targets,
                               std::span<const std::uint32_t> meshes) const {
  if (meshes.empty()) return false;
  const ShaftLight& from = rays_.visibility(light).shaftLight();
  const ShaftHull hull(from.center, from.radius, targets.box);
  return std::ranges::any_of(
      meshes, [&](std::uint32_t mesh) { return hull.mayMeet(rays_.scene().level(), mesh); });
}

void SampleShafts::find(std::size_t light, const SampleBlocks& blocks,
                        const SampleBlocks::Block& block, std::size_t depth,
                        std::span<double> seen) {
  const ShaftLight& from = rays_.visibility(light).shaftLight();
  const KnownRays known{shaftAt(depth), follow(depth, light, from, blocks.targetsOf(block))};
  if (known.outcome != TargetVisibility::Unknown)
    return findEach(light, blocks, block, known, seen);
  for (const SampleBlocks::Block& part : blocks.partsOf(block))
    find(light, blocks, part, depth + 1, seen);
  if (block.parts > 0) return;
  if (from.radius == 0) return findEach(light, blocks, block, known, seen);
  forEachSample(blocks, block, [&](std::size_t index) {
    seen[index] = seenFraction(rays_.visibility(light), light, blocks.samples()[index], depth + 1);
  });
}

void SampleShafts::findEach(std::size_t light, const SampleBlocks& blocks,
                            const SampleBlocks::Block& block, const KnownRays& known,
                            std::span<double> seen) {
  if (known.outcome == TargetVisibility::Dark && block.surface == rays_.id())
    return rays_.countSamples(light, static_cast<std::int64_t>(block.count));
  forEachSample(blocks, block, [&](std::size_t index) {
    seen[index] =
        rays_.seenFraction(rays_.visibility(light), light, blocks.samples()[index], &known);
  });
}

double SampleShafts::seenFraction(const LightVisibility& visibility, std::size_t light,
                                  const SamplePoint& at, std::size_t depth) {
  const Surface& surface = rays_.scene()[at.surface];
  const ShaftTargets target{TargetBox::ofPoint(at.target, rays_.surface(rays_.id()).normal),
                            {&surface.sector, 1}};
  const KnownRays known{shaftAt(depth), follow(depth, light, visibility.shaftLight(), target)};
  return rays_.seenFraction(visibility, light, at, &known);
}

}  // namespace hearth
