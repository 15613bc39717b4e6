#include "light/baking/sample_suns.h"

#include <cstdint>

namespace hearth {

void SampleSuns::find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen) {
  find(light, blocks, blocks.whole(), 0, seen);
}

SkyShaft& SampleSuns::shaftAt(std::size_t depth) {
  while (shafts_.size() <= depth) shafts_.emplace_back(rays_.scene());
  return shafts_[depth];
}

void SampleSuns::find(std::size_t light, const SampleBlocks& blocks,
                      const SampleBlocks::Block& block, std::size_t depth, std::span<double> seen) {
  const SunVisibility& sun = *rays_.sun(light);
  SkyShaft& shaft = shaftAt(depth);
  const TargetVisibility outcome =
      shaft.follow(sun.cone(), blocks.targetsOf(block), depth > 0 ? &shafts_[depth - 1] : nullptr);
  if (SectorSet* met = depth == 0 ? rays_.enteredSectors(light) : nullptr) shaft.addSectorsTo(*met);
  if (outcome == TargetVisibility::Dark && block.surface == rays_.id())
    return rays_.countSamples(light, static_cast<std::int64_t>(block.count));
  if (outcome == TargetVisibility::Unknown && block.parts > 0) {
    for (const SampleBlocks::Block& part : blocks.partsOf(block))
      find(light, blocks, part, depth + 1, seen);
    return;
  }
  const KnownSkyRays known{shaft, outcome};
  forEachSample(blocks, block, [&](std::size_t index) {
    seen[index] = rays_.seenFraction(sun, light, blocks.samples()[index], &known);
  });
}

}  // namespace hearth
