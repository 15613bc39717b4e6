#include "light/baking/sample_beams.h"

#include <algorithm>

namespace hearth {

const Segment* SampleBeams::wallOf(SurfaceId surface) const {
  const Surface& there = rays_.scene()[surface];
  return there.segment ? &rays_.scene()[*there.segment] : nullptr;
}

/// Of points that are lit, or may lie in those of `candidates_` from `first` on.
SampleBeams::BeamAnswer SampleBeams::answerFor(SurfaceId surface, bool areLit,
                                               std::size_t first) const {
  const bool areDark = !areLit && first == candidates_.size();
  const TargetVisibility outcome = areLit    ? TargetVisibility::Lit
                                   : areDark ? TargetVisibility::Dark
                                             : TargetVisibility::Unknown;
  return {surface, true, outcome, true, first, candidates_.size()};
}

SampleBeams::BeamAnswer SampleBeams::ask(std::size_t light, SurfaceId surface,
                                         std::span<const Vec3> corners) {
  const std::size_t first = candidates_.size();
  if (!rays_.canShineOn(light, surface))
    return {surface, false, TargetVisibility::Dark, true, first, first};
  const BeamTree& beams = treeOf(light);
  const SectorId sector = rays_.scene()[surface].sector;
  const LitSurface& there = rays_.surface(surface);
  const BeamTree::Points points = beams.pointsBetween(corners);
  if (!beams.knows(sector, {there.anchor, there.normal}, points))
    return {surface, true, TargetVisibility::Unknown, false, first, first};
  return answerFor(surface, beams.find(sector, wallOf(surface), points, candidates_), first);
}

/// Of points among those that `before` is about.
SampleBeams::BeamAnswer SampleBeams::refine(std::size_t light, const BeamAnswer& before,
                                            std::span<const Vec3> corners) {
  if (!before.isAnswered || before.outcome != TargetVisibility::Unknown) return before;
  const BeamTree& beams = treeOf(light);
  const std::size_t first = candidates_.size();
  const bool isLit = beams.narrow(beams.pointsBetween(corners), wallOf(before.surface), candidates_,
                                  before.first, before.last);
  return answerFor(before.surface, isLit, first);
}

void SampleBeams::find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen) {
  const SampleBlocks::Block& whole = blocks.whole();
  if (rays_.enteredSectors(light)) shafts_.noteSectors(light, blocks.targetsOf(whole));
  candidates_.clear();
  answers_.clear();
  meshes_.reset();
  for (const SurfaceId surface : blocks.surfaces())
    answers_.push_back(ask(light, surface, whole.box.corners()));
  findBlock({light, blocks, seen}, whole, {0, answers_.size()});
}

/// Of a block among the samples that `around` is about.
void SampleBeams::findWithin(const Query& query, const SampleBlocks::Block& block, Range around) {
  const std::size_t beamsBefore = candidates_.size();
  const Range here{answers_.size(), answers_.size() + (around.last - around.first)};
  for (std::size_t i = around.first; i < around.last; ++i)
    if (!block.surface || answers_[i].surface == *block.surface)
      answers_.push_back(refine(query.light, answers_[i], block.box.corners()));
  findBlock(query, block, {here.first, answers_.size()});
  answers_.erase(answers_.begin() + static_cast<std::ptrdiff_t>(here.first), answers_.end());
  candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(beamsBefore),
                    candidates_.end());
}

/// Of a block that `here` is about.
void SampleBeams::findBlock(const Query& query, const SampleBlocks::Block& block, Range here) {
  constexpr int kMaxAtOnce = 8;  // a side
  const bool isSmall = block.columns <= kMaxAtOnce && block.rows <= kMaxAtOnce;
  const BeamAnswer& first = answers_[here.first];
  const auto isAsFirst = [&](const BeamAnswer& other) {
    return other.isInFront == first.isInFront && other.isAnswered && other.outcome == first.outcome;
  };
  if (block.surface && !first.isAnswered)
    return shafts_.find(query.light, query.blocks, block, query.seen);
  const bool areAlike =
      first.outcome != TargetVisibility::Unknown && std::ranges::all_of(in(here), isAsFirst);
  const bool areDark = areAlike && first.outcome == TargetVisibility::Dark;
  const bool isLeaf =
      isSmall && (block.parts == 0 || std::ranges::all_of(in(here), &BeamAnswer::isAnswered));
  // Beams know of no meshes.
  if (!areDark && (areAlike || isLeaf) && mayMeetMesh(query, block))
    return shafts_.find(query.light, query.blocks, block, query.seen);
  if (areAlike) {
    if (first.isInFront) findAlike(query, block, !areDark);
  } else if (isLeaf) {
    findOneByOne(query, block, in(here));
  } else {
    for (const SampleBlocks::Block& part : query.blocks.partsOf(block))
      findWithin(query, part, here);
  }
}

/// Whether a mesh may stop rays to a block.
bool SampleBeams::mayMeetMesh(const Query& query, const SampleBlocks::Block& block) {
  const auto& [light, blocks, seen] = query;
  if (!meshes_) meshes_ = shafts_.meshesToMeet(light, blocks.targetsOf(blocks.whole()));
  return shafts_.mayMeetMesh(light, blocks.targetsOf(block), *meshes_);
}

/// The light can shine on all surfaces of the block.
void SampleBeams::findAlike(const Query& query, const SampleBlocks::Block& block, bool areLit) {
  rays_.countSamples(query.light, block.samples);
  if (!areLit) return;
  if (rays_.isAllInReach(query.light, block.box)) {
    rays_.countSeenSamples(query.light, block.samples);
    return forEachSample(query.blocks, block, [&](std::size_t index) { query.seen[index] = 1; });
  }
  forEachSample(query.blocks, block, [&](std::size_t index) {
    query.seen[index] = rays_.unoccludedFraction(query.light, query.blocks.samples()[index]);
  });
}

/// Whatever beams can tell of each sample, and what is left by rays.
void SampleBeams::findOneByOne(const Query& query, const SampleBlocks::Block& block,
                               std::span<const BeamAnswer> here) {
  for (const BeamAnswer& answer : here) findOn(answer, query, block);
  forEachSample(query.blocks, block, [&](std::size_t index) {
    const SamplePoint& at = query.blocks.samples()[index];
    const BeamAnswer& there = *std::ranges::find(here, at.surface, &BeamAnswer::surface);
    if (!there.isInFront) return;
    if (query.seen[index] == kUnknownFraction) {
      query.seen[index] = seenFraction(query.light, at, there);
      return;
    }
    rays_.countSamples(query.light, 1);
    if (query.seen[index] > 0) query.seen[index] = rays_.unoccludedFraction(query.light, at);
  });
}

/// Of the samples of a block that lie on one of its surfaces.
void SampleBeams::findOn(const BeamAnswer& here, const Query& query,
                         const SampleBlocks::Block& block) {
  const BeamTree& beams = treeOf(query.light);
  const auto seenIfOn = [&](double fraction) {
    forEachSample(query.blocks, block, [&](std::size_t index) {
      if (query.blocks.samples()[index].surface == here.surface) query.seen[index] = fraction;
    });
  };
  if (!here.isAnswered) return seenIfOn(kUnknownFraction);
  if (here.outcome != TargetVisibility::Unknown)
    return seenIfOn(here.outcome == TargetVisibility::Lit ? 1 : 0);
  const std::size_t first = query.blocks.index(block.column, block.row);
  if (!block.surface) seenIfOn_.resize(query.seen.size());
  const std::span<double> seen = block.surface ? query.seen : std::span(seenIfOn_);
  beams.findSeen(beams.pointsBetween(block.box.corners()), wallOf(here.surface),
                 std::span(candidates_).subspan(here.first, here.last - here.first),
                 {query.blocks.targets().from(first), static_cast<std::size_t>(block.columns),
                  static_cast<std::size_t>(block.rows), query.blocks.index(0, 1)},
                 scratch_, &seen[first]);
  if (block.surface) return;
  forEachSample(query.blocks, block, [&](std::size_t index) {
    if (query.blocks.samples()[index].surface == here.surface) query.seen[index] = seenIfOn_[index];
  });
}

/// Of one of the samples that `around` is about.
double SampleBeams::seenFraction(std::size_t light, const SamplePoint& at,
                                 const BeamAnswer& around) {
  const std::size_t before = candidates_.size();
  const KnownRays known{shafts_.any(), refine(light, around, {&at.target, 1}).outcome};
  candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(before), candidates_.end());
  return rays_.seenFraction(rays_.visibility(light), light, at,
                            known.outcome == TargetVisibility::Unknown ? nullptr : &known);
}

}  // namespace hearth
