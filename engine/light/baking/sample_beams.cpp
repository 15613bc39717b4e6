#include "light/baking/sample_beams.h"

#include <algorithm>

namespace hearth {

const Segment* SampleBeams::wallOf(SurfaceId surface) const {
  const Surface& there = rays_.scene()[surface];
  return there.segment ? &rays_.scene()[*there.segment] : nullptr;
}

/// Of points that are lit, or may lie in those of `beams_` from `first` on.
SampleBeams::OnSurface SampleBeams::lyingIn(SurfaceId surface, bool areLit,
                                            std::size_t first) const {
  const bool areDark = !areLit && first == beams_.size();
  const Shaft::Outcome outcome = areLit    ? Shaft::Outcome::Lit
                                 : areDark ? Shaft::Outcome::Dark
                                           : Shaft::Outcome::Unknown;
  return {surface, true, outcome, true, first, beams_.size()};
}

SampleBeams::OnSurface SampleBeams::found(std::size_t light, SurfaceId surface,
                                          std::span<const Vec3> corners) {
  const std::size_t first = beams_.size();
  if (!rays_.canShineOn(light, surface))
    return {surface, false, Shaft::Outcome::Dark, true, first, first};
  const BeamTree& beams = treeOf(light);
  const SectorId sector = rays_.scene()[surface].sector;
  const LitSurface& there = rays_.surface(surface);
  const BeamTree::Points points = beams.seen(corners);
  if (!beams.knows(sector, {there.anchor, there.normal}, points))
    return {surface, true, Shaft::Outcome::Unknown, false, first, first};
  return lyingIn(surface, beams.find(sector, wallOf(surface), points, beams_), first);
}

/// Of points among those that `before` is about.
SampleBeams::OnSurface SampleBeams::narrowed(std::size_t light, const OnSurface& before,
                                             std::span<const Vec3> corners) {
  if (!before.isKnown || before.outcome != Shaft::Outcome::Unknown) return before;
  const BeamTree& beams = treeOf(light);
  const std::size_t first = beams_.size();
  const bool isLit =
      beams.narrow(beams.seen(corners), wallOf(before.surface), beams_, before.first, before.last);
  return lyingIn(before.surface, isLit, first);
}

void SampleBeams::find(std::size_t light, const SampleBlocks& blocks, std::span<double> seen) {
  const SampleBlocks::Block& whole = blocks.whole();
  if (rays_.sectorsMetBy(light)) shafts_.noteSectors(light, blocks.targetsOf(whole));
  beams_.clear();
  onSurfaces_.clear();
  for (const SurfaceId surface : blocks.surfaces())
    onSurfaces_.push_back(found(light, surface, whole.box.corners()));
  findBlock({light, blocks, seen}, whole, {0, onSurfaces_.size()});
}

/// Of a block among the samples that `around` is about.
void SampleBeams::findWithin(const Task& task, const SampleBlocks::Block& block, Range around) {
  const std::size_t beamsBefore = beams_.size();
  const Range here{onSurfaces_.size(), onSurfaces_.size() + (around.last - around.first)};
  for (std::size_t i = around.first; i < around.last; ++i)
    if (!block.surface || onSurfaces_[i].surface == *block.surface)
      onSurfaces_.push_back(narrowed(task.light, onSurfaces_[i], block.box.corners()));
  findBlock(task, block, {here.first, onSurfaces_.size()});
  onSurfaces_.erase(onSurfaces_.begin() + static_cast<std::ptrdiff_t>(here.first),
                    onSurfaces_.end());
  beams_.erase(beams_.begin() + static_cast<std::ptrdiff_t>(beamsBefore), beams_.end());
}

/// Of a block that `here` is about.
void SampleBeams::findBlock(const Task& task, const SampleBlocks::Block& block, Range here) {
  constexpr int kMostAtOnce = 8;  // a side
  const bool isSmall = block.columns <= kMostAtOnce && block.rows <= kMostAtOnce;
  const OnSurface& first = onSurfaces_[here.first];
  const auto isAsFirst = [&](const OnSurface& other) {
    return other.isInFront == first.isInFront && other.isKnown && other.outcome == first.outcome;
  };
  if (block.surface && !first.isKnown)
    return shafts_.find(task.light, task.blocks, block, task.seen);
  if (first.outcome != Shaft::Outcome::Unknown && std::ranges::all_of(in(here), isAsFirst)) {
    if (first.isInFront) findAlike(task, block, first.outcome == Shaft::Outcome::Lit);
  } else if (isSmall && (block.parts == 0 || std::ranges::all_of(in(here), &OnSurface::isKnown))) {
    findOneByOne(task, block, in(here));
  } else {
    for (const SampleBlocks::Block& part : task.blocks.partsOf(block)) findWithin(task, part, here);
  }
}

/// The light can shine on all surfaces of the block.
void SampleBeams::findAlike(const Task& task, const SampleBlocks::Block& block, bool areLit) {
  rays_.countSamples(task.light, std::int64_t{block.columns} * block.rows);
  if (!areLit) return;
  forEachSample(task.blocks, block, [&](std::size_t index) {
    task.seen[index] = rays_.unhiddenFraction(task.light, task.blocks.samples()[index]);
  });
}

/// Whatever beams can tell of each sample, and what is left by rays.
void SampleBeams::findOneByOne(const Task& task, const SampleBlocks::Block& block,
                               std::span<const OnSurface> here) {
  for (const OnSurface& onSurface : here) findOn(onSurface, task, block);
  forEachSample(task.blocks, block, [&](std::size_t index) {
    const SamplePoint& at = task.blocks.samples()[index];
    const OnSurface& there = *std::ranges::find(here, at.surface, &OnSurface::surface);
    if (!there.isInFront) return;
    if (task.seen[index] == kUnknownFraction) {
      task.seen[index] = seenFraction(task.light, at, there);
      return;
    }
    rays_.countSamples(task.light, 1);
    if (task.seen[index] > 0) task.seen[index] = rays_.unhiddenFraction(task.light, at);
  });
}

/// Of the samples of a block that lie on one of its surfaces.
void SampleBeams::findOn(const OnSurface& here, const Task& task,
                         const SampleBlocks::Block& block) {
  const BeamTree& beams = treeOf(task.light);
  const auto seenIfOn = [&](double fraction) {
    forEachSample(task.blocks, block, [&](std::size_t index) {
      if (task.blocks.samples()[index].surface == here.surface) task.seen[index] = fraction;
    });
  };
  if (!here.isKnown) return seenIfOn(kUnknownFraction);
  if (here.outcome != Shaft::Outcome::Unknown)
    return seenIfOn(here.outcome == Shaft::Outcome::Lit ? 1 : 0);
  const std::size_t first = task.blocks.index(block.column, block.row);
  if (!block.surface) seenIfOn_.resize(task.seen.size());
  const std::span<double> seen = block.surface ? task.seen : std::span(seenIfOn_);
  beams.findSeen(beams.seen(block.box.corners()), wallOf(here.surface),
                 std::span(beams_).subspan(here.first, here.last - here.first),
                 {task.blocks.targets().from(first), static_cast<std::size_t>(block.columns),
                  static_cast<std::size_t>(block.rows), task.blocks.index(0, 1)},
                 parting_, &seen[first]);
  if (block.surface) return;
  forEachSample(task.blocks, block, [&](std::size_t index) {
    if (task.blocks.samples()[index].surface == here.surface) task.seen[index] = seenIfOn_[index];
  });
}

/// Of one of the samples that `around` is about.
double SampleBeams::seenFraction(std::size_t light, const SamplePoint& at,
                                 const OnSurface& around) {
  const std::size_t before = beams_.size();
  const KnownRays known{shafts_.any(), narrowed(light, around, {&at.target, 1}).outcome};
  beams_.erase(beams_.begin() + static_cast<std::ptrdiff_t>(before), beams_.end());
  return rays_.seenFraction(rays_.sight(light), light, at,
                            known.outcome == Shaft::Outcome::Unknown ? nullptr : &known);
}

}  // namespace hearth
