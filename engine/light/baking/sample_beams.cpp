#include "light/baking/sample_beams.h"

namespace hearth {

const Segment* SampleBeams::wallOf(SurfaceId surface) const {
  const Surface& there = rays_.scene()[surface];
  return there.segment ? &rays_.scene()[*there.segment] : nullptr;
}

/// Of points that are lit, or may lie in those of `candidates_` from `first` on.
SampleBeams::BeamAnswer SampleBeams::answerFor(bool areLit, std::size_t first) const {
  const TargetVisibility outcome = areLit                        ? TargetVisibility::Lit
                                   : first == candidates_.size() ? TargetVisibility::Dark
                                                                 : TargetVisibility::Unknown;
  return {outcome, first, candidates_.size()};
}

void SampleBeams::find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen) {
  if (rays_.enteredSectors(light)) shafts_.noteSectors(light, blocks.targetsOf(blocks.whole()));
  meshes_.reset();
  for (const SampleBlocks::Block& block : blocks.onSurfaces())
    findOnSurface({light, blocks, seen}, block);
}

/// Of all samples on one surface. A continuation may be tilted away from the light.
void SampleBeams::findOnSurface(const Query& query, const SampleBlocks::Block& block) {
  if (!rays_.canShineOn(query.light, *block.surface)) return;
  const BeamTree& beams = treeOf(query.light);
  const LitSurface& surface = rays_.surface(*block.surface);
  const TargetBox box = query.blocks.boxOf(block);
  const BeamTree::Points points = beams.pointsBetween(box.corners());
  if (!beams.knows(*block.sector, {surface.anchor, surface.normal}, points))
    return shafts_.find(query.light, query.blocks, block, query.seen);
  candidates_.clear();
  const bool areLit = beams.find(*block.sector, wallOf(*block.surface), points, candidates_);
  findBlock(query, block, answerFor(areLit, 0));
}

/// Of points on a surface among those that `around` is about.
SampleBeams::BeamAnswer SampleBeams::refine(std::size_t light, SurfaceId surface,
                                            const BeamAnswer& around,
                                            std::span<const Vec3> corners) {
  const BeamTree& beams = treeOf(light);
  const std::size_t first = candidates_.size();
  const bool areLit = beams.narrow(beams.pointsBetween(corners), wallOf(surface), candidates_,
                                   around.first, around.last);
  return answerFor(areLit, first);
}

/// Of a block that `here` is about.
void SampleBeams::findBlock(const Query& query, const SampleBlocks::Block& block,
                            const BeamAnswer& here) {
  constexpr std::size_t kMostAtOnce = 256;
  if (here.outcome == TargetVisibility::Dark)
    return rays_.countSamples(query.light, static_cast<std::int64_t>(block.count));
  const bool isLit = here.outcome == TargetVisibility::Lit;
  const bool isLeaf = block.count <= kMostAtOnce;
  // Beams know of no meshes.
  if ((isLit || isLeaf) && mayMeetMesh(query, block))
    return shafts_.find(query.light, query.blocks, block, query.seen);
  if (isLit) return findLit(query, block);
  if (isLeaf) return findOneByOne(query, block, here);
  for (const SampleBlocks::Block& part : query.blocks.partsOf(block)) {
    findBlock(query, part,
              refine(query.light, *block.surface, here, query.blocks.boxOf(part).corners()));
    candidates_.resize(here.last);
  }
}

/// Whether a mesh may stop rays to a block.
bool SampleBeams::mayMeetMesh(const Query& query, const SampleBlocks::Block& block) {
  const auto& [light, blocks, seen] = query;
  if (!meshes_) meshes_ = shafts_.meshesToMeet(light, blocks.targetsOf(blocks.whole()));
  return shafts_.mayMeetMesh(light, blocks.targetsOf(block), *meshes_);
}

void SampleBeams::findLit(const Query& query, const SampleBlocks::Block& block) {
  rays_.countSamples(query.light, static_cast<std::int64_t>(block.count));
  if (rays_.isAllInReach(query.light, query.blocks.boxOf(block))) {
    rays_.countSeenSamples(query.light, static_cast<std::int64_t>(block.count));
    return forEachSample(query.blocks, block, [&](std::size_t index) { query.seen[index] = 1; });
  }
  forEachSample(query.blocks, block, [&](std::size_t index) {
    query.seen[index] = rays_.unoccludedFraction(query.light, query.blocks.samples()[index]);
  });
}

/// Whatever beams can tell of each sample, and what is left by rays.
void SampleBeams::findOneByOne(const Query& query, const SampleBlocks::Block& block,
                               const BeamAnswer& here) {
  const auto& [light, blocks, seen] = query;
  const BeamTree& beams = treeOf(light);
  const TargetBox box = blocks.boxOf(block);
  seenHere_.resize(block.count + SampleArrays::kMaxLanes);
  beams.findSeen(beams.pointsBetween(box.corners()), wallOf(*block.surface),
                 std::span(candidates_).subspan(here.first, here.last - here.first),
                 blocks.targets(block), block.count, scratch_, seenHere_.data());
  const bool areInReach = rays_.isAllInReach(light, box);
  std::int64_t known = 0;
  std::int64_t seenInReach = 0;
  const double* fraction = seenHere_.data();
  for (const std::uint32_t index : blocks.indices(block)) {
    const double found = *fraction++;
    if (found == kUnknownFraction) {
      seen[index] = seenFraction(light, blocks.samples()[index], here);
      continue;
    }
    ++known;
    if (found == 0) continue;
    seen[index] = areInReach ? 1 : rays_.unoccludedFraction(light, blocks.samples()[index]);
    if (areInReach) ++seenInReach;
  }
  rays_.countSamples(light, known);
  rays_.countSeenSamples(light, seenInReach);
}

/// Of one of the samples that `around` is about.
double SampleBeams::seenFraction(std::size_t light, const SamplePoint& at,
                                 const BeamAnswer& around) {
  const KnownRays known{shafts_.any(), refine(light, at.surface, around, {&at.target, 1}).outcome};
  candidates_.resize(around.last);
  return rays_.seenFraction(rays_.visibility(light), light, at,
                            known.outcome == TargetVisibility::Unknown ? nullptr : &known);
}

}  // namespace hearth
