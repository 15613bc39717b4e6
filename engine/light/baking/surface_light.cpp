#include "light/baking/surface_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether any of the light can shine on the plane of the surface. Of a ball that can be a part,
/// but none where its middle lies in the plane.
bool isInFront(const LightSource& light, double radius, const LitSurface& surface) {
  const double distance = surface.distanceInFront(light.position);
  return std::abs(distance) > kInPlane && distance > -radius;
}

/// Corners of all that samples of the surface can lie on, within tolerances.
std::array<Vec3, 4> cornersOf(const LitSurface& surface) {
  const TexelRect& rect = surface.texels;
  const double i0 = rect.i0;
  const double j0 = rect.j0;
  return {surface.toWorld({i0, j0}), surface.toWorld({i0 + rect.width, j0}),
          surface.toWorld({i0, j0 + rect.height}),
          surface.toWorld({i0 + rect.width, j0 + rect.height})};
}

/// Metres from a point to the box, along the axes, around some others: to what these span it is no
/// less.
double distanceToBox(Vec3 from, std::span<const Vec3> corners) {
  const auto along = [&](double Vec3::*axis) {
    const auto [least, most] = std::ranges::minmax(corners, {}, axis);
    return std::max({0.0, least.*axis - from.*axis, from.*axis - most.*axis});
  };
  return length(Vec3{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)});
}

template <typename Visit>
void forEachSample(const SampleBlocks& blocks, const SampleBlocks::Block& block, Visit&& visit) {
  for (int j = block.row; j < block.row + block.rows; ++j)
    for (int i = block.column; i < block.column + block.columns; ++i) visit(blocks.index(i, j));
}

}  // namespace

SurfaceLight::SurfaceLight(const Scene& scene, const LitSurfaces& surfaces,
                           const LightSights& sights, bool lambert, SurfaceId id, Seeing seeing,
                           LightDependencies* dependencies)
    : scene_(scene),
      surfaces_(surfaces),
      sights_(sights),
      surface_(*surfaces[id.index()]),
      id_(id),
      lambert_(lambert),
      seeing_(seeing),
      dependencies_(dependencies),
      placement_(surfaces, id, dependencies ? &dependencies->surfaces() : nullptr),
      costs_(scene.level().lights.size()) {
  for (std::size_t i = 0; i < costs_.size(); ++i)
    if (isInFront(light(i), radiusOf(i), surface_) && reachesBox(i, cornersOf(surface_)))
      facing_.push_back(i);
}

double SurfaceLight::radiusOf(std::size_t light) const {
  return sights_.fine[light].shaftLight().radius;
}

int SurfaceLight::channels() const {
  const auto isColored = [this](std::size_t i) { return light(i).isColored(); };
  return std::ranges::any_of(facing_, isColored) ? 3 : 1;
}

bool SurfaceLight::reachesBox(std::size_t light, std::span<const Vec3> corners) const {
  return distanceToBox(scene_.level().lights[light].position, corners) <
         sights_.reach[light] + kAuthorNoise;
}

bool SurfaceLight::reaches(std::size_t light, const SampleBlocks& blocks) const {
  return reachesBox(light, blocks.whole().box.corners());
}

SamplePoint SurfaceLight::place(Vec2 texelPoint) const { return placement_.place(texelPoint); }

void SurfaceLight::placeRow(std::span<const double> columns, double row,
                            std::vector<SamplePoint>& places) const {
  placement_.placeRow(columns, row, places);
}

SampleBlocks SurfaceLight::inBlocks(std::vector<SamplePoint> samples, int columns, int rows) const {
  return {scene_.level(), surface_, std::move(samples), columns, rows};
}

double SurfaceLight::seenFraction(const LightSight& sight, std::size_t index, const SamplePoint& at,
                                  const Known* known) {
  if (!canShineOn(index, at.surface)) return 0;
  const LitSurface& there = *surfaces_[at.surface.index()];
  LightCost& cost = costs_[index];
  ++cost.samples;
  if (!isInReach(index, at)) return 0;
  const LightTarget target{at.target, scene_[at.surface].sector, {there.anchor, there.normal}};
  const double seen = known ? sight.seenFraction(target, known->shaft, known->outcome, cost.rays)
                            : sight.seenFraction(target, cost.rays, metBy(index));
  if (seen > 0) ++cost.seenSamples;
  return seen;
}

/// What continues a surface may lie a tolerance off its plane.
bool SurfaceLight::canShineOn(std::size_t index, SurfaceId surface) const {
  return surface == id_ || isInFront(light(index), radiusOf(index), *surfaces_[surface.index()]);
}

const std::vector<double>& SurfaceLight::seenFractions(std::size_t light,
                                                       const SampleBlocks& blocks) {
  seen_.assign(blocks.samples().size(), 0);
  if (seeing_ == Seeing::ByShafts && sights_.fine[light].beams())
    addPointLight(light, blocks);
  else if (seeing_ == Seeing::ByShafts)
    addBlock(light, blocks, blocks.whole(), 0);
  else
    for (std::size_t i = 0; i < seen_.size(); ++i)
      seen_[i] = seenFraction(light, blocks.samples()[i]);
  return seen_;
}

double SurfaceLight::seenFraction(std::size_t light, const SamplePoint& at) {
  return seenFraction(sights_.fine[light], light, at, nullptr);
}

const Segment* SurfaceLight::wallOf(SurfaceId surface) const {
  const Surface& there = scene_[surface];
  return there.segment ? &scene_[*there.segment] : nullptr;
}

/// Of points that are lit, or may lie in those of `beams_` from `first` on.
SurfaceLight::ByBeams SurfaceLight::byBeams(SurfaceId surface, bool areLit,
                                            std::size_t first) const {
  const bool areDark = !areLit && first == beams_.size();
  const Shaft::Outcome outcome = areLit    ? Shaft::Outcome::Lit
                                 : areDark ? Shaft::Outcome::Dark
                                           : Shaft::Outcome::Unknown;
  return {surface, true, outcome, true, first, beams_.size()};
}

SurfaceLight::ByBeams SurfaceLight::findBeams(std::size_t light, SurfaceId surface,
                                              std::span<const Vec3> corners) {
  const std::size_t first = beams_.size();
  if (!canShineOn(light, surface))
    return {surface, false, Shaft::Outcome::Dark, true, first, first};
  const BeamTree& beams = *sights_.fine[light].beams();
  const SectorId sector = scene_[surface].sector;
  const LitSurface& there = *surfaces_[surface.index()];
  const BeamTree::Points points = beams.seen(corners);
  if (!beams.knows(sector, {there.anchor, there.normal}, points))
    return {surface, true, Shaft::Outcome::Unknown, false, first, first};
  return byBeams(surface, beams.find(sector, wallOf(surface), points, beams_), first);
}

/// Of points among those that `before` is about.
SurfaceLight::ByBeams SurfaceLight::narrowed(std::size_t light, const ByBeams& before,
                                             std::span<const Vec3> corners) {
  if (!before.isKnown || before.outcome != Shaft::Outcome::Unknown) return before;
  const BeamTree& beams = *sights_.fine[light].beams();
  const std::size_t first = beams_.size();
  const bool isLit =
      beams.narrow(beams.seen(corners), wallOf(before.surface), beams_, before.first, before.last);
  return byBeams(before.surface, isLit, first);
}

void SurfaceLight::addPointLight(std::size_t light, const SampleBlocks& blocks) {
  const SampleBlocks::Block& whole = blocks.whole();
  if (dependencies_)
    followShaft(0, light, sights_.fine[light].shaftLight(), blocks.targetsOf(whole));
  beams_.clear();
  byBeams_.clear();
  for (const SurfaceId surface : blocks.surfaces())
    byBeams_.push_back(findBeams(light, surface, whole.box.corners()));
  addAllByBeams(light, blocks, whole, {0, byBeams_.size()});
}

/// Of a block among the samples that `around` is about.
void SurfaceLight::addByBeams(std::size_t light, const SampleBlocks& blocks,
                              const SampleBlocks::Block& block, Range around) {
  const std::size_t beamsBefore = beams_.size();
  const Range here{byBeams_.size(), byBeams_.size() + (around.last - around.first)};
  for (std::size_t i = around.first; i < around.last; ++i)
    if (!block.surface || byBeams_[i].surface == *block.surface)
      byBeams_.push_back(narrowed(light, byBeams_[i], block.box.corners()));
  addAllByBeams(light, blocks, block, {here.first, byBeams_.size()});
  byBeams_.erase(byBeams_.begin() + static_cast<std::ptrdiff_t>(here.first), byBeams_.end());
  beams_.erase(beams_.begin() + static_cast<std::ptrdiff_t>(beamsBefore), beams_.end());
}

/// Of a block that `here` is about.
void SurfaceLight::addAllByBeams(std::size_t light, const SampleBlocks& blocks,
                                 const SampleBlocks::Block& block, Range here) {
  constexpr int kMostAtOnce = 8;  // a side
  const bool isSmall = block.columns <= kMostAtOnce && block.rows <= kMostAtOnce;
  const ByBeams& first = byBeams_[here.first];
  const auto isAsFirst = [&](const ByBeams& other) {
    return other.isInFront == first.isInFront && other.isKnown && other.outcome == first.outcome;
  };
  if (block.surface && !first.isKnown) return addBlock(light, blocks, block, 0);
  if (first.outcome != Shaft::Outcome::Unknown && std::ranges::all_of(in(here), isAsFirst)) {
    if (first.isInFront) addAlike(light, blocks, block, first.outcome == Shaft::Outcome::Lit);
  } else if (isSmall && (block.parts == 0 || std::ranges::all_of(in(here), &ByBeams::isKnown))) {
    addOneByOne(light, blocks, block, in(here));
  } else {
    for (const SampleBlocks::Block& part : blocks.partsOf(block))
      addByBeams(light, blocks, part, here);
  }
}

/// The light can shine on all surfaces of the block.
void SurfaceLight::addAlike(std::size_t light, const SampleBlocks& blocks,
                            const SampleBlocks::Block& block, bool areLit) {
  costs_[light].samples += std::int64_t{block.columns} * block.rows;
  if (!areLit) return;
  forEachSample(blocks, block,
                [&](std::size_t index) { see(light, blocks.samples()[index], seen_[index]); });
}

/// Whatever beams can tell of each sample, and what is left by rays.
void SurfaceLight::addOneByOne(std::size_t light, const SampleBlocks& blocks,
                               const SampleBlocks::Block& block, std::span<const ByBeams> here) {
  for (const ByBeams& onSurface : here) findSeenOf(onSurface, light, blocks, block);
  forEachSample(blocks, block, [&](std::size_t index) {
    const SamplePoint& at = blocks.samples()[index];
    const ByBeams& there = *std::ranges::find(here, at.surface, &ByBeams::surface);
    if (!there.isInFront) return;
    if (seen_[index] == kUnknownFraction) {
      seen_[index] = seenFractionByBeams(light, at, there);
      return;
    }
    ++costs_[light].samples;
    if (seen_[index] > 0) see(light, at, seen_[index]);
  });
}

/// Of the samples of a block that lie on one of its surfaces.
void SurfaceLight::findSeenOf(const ByBeams& here, std::size_t light, const SampleBlocks& blocks,
                              const SampleBlocks::Block& block) {
  const BeamTree& beams = *sights_.fine[light].beams();
  const auto seenIfOn = [&](double fraction) {
    forEachSample(blocks, block, [&](std::size_t index) {
      if (blocks.samples()[index].surface == here.surface) seen_[index] = fraction;
    });
  };
  if (!here.isKnown) return seenIfOn(kUnknownFraction);
  if (here.outcome != Shaft::Outcome::Unknown)
    return seenIfOn(here.outcome == Shaft::Outcome::Lit ? 1 : 0);
  const std::size_t first = blocks.index(block.column, block.row);
  std::vector<double>& seen = block.surface ? seen_ : seenIfOn_;
  seen.resize(seen_.size());
  beams.findSeen(beams.seen(block.box.corners()), wallOf(here.surface),
                 std::span(beams_).subspan(here.first, here.last - here.first),
                 {blocks.targets().from(first), static_cast<std::size_t>(block.columns),
                  static_cast<std::size_t>(block.rows), blocks.index(0, 1)},
                 parting_, &seen[first]);
  if (block.surface) return;
  forEachSample(blocks, block, [&](std::size_t index) {
    if (blocks.samples()[index].surface == here.surface) seen_[index] = seenIfOn_[index];
  });
}

/// Of one of the samples that `around` is about.
double SurfaceLight::seenFractionByBeams(std::size_t light, const SamplePoint& at,
                                         const ByBeams& around) {
  const std::size_t before = beams_.size();
  const Known known{shaftAt(0), narrowed(light, around, {&at.target, 1}).outcome};
  beams_.erase(beams_.begin() + static_cast<std::ptrdiff_t>(before), beams_.end());
  return seenFraction(sights_.fine[light], light, at,
                      known.outcome == Shaft::Outcome::Unknown ? nullptr : &known);
}

/// All of a light that nothing is before, unless it is too far away.
void SurfaceLight::see(std::size_t light, const SamplePoint& at, double& seen) {
  seen = isInReach(light, at) ? 1 : 0;
  if (seen > 0) ++costs_[light].seenSamples;
}

Shaft& SurfaceLight::shaftAt(std::size_t depth) {
  while (shafts_.size() <= depth) shafts_.emplace_back(scene_);
  return shafts_[depth];
}

/// Within that of less depth, if there is one.
Shaft::Outcome SurfaceLight::followShaft(std::size_t depth, std::size_t light,
                                         const ShaftLight& from, const ShaftTargets& targets) {
  Shaft& shaft = shaftAt(depth);
  if (depth > 0) return shaft.follow(from, targets, &shafts_[depth - 1]);
  const Shaft::Outcome outcome = shaft.follow(from, targets, nullptr);
  if (SectorSet* met = metBy(light)) shaft.addSectorsTo(*met);
  return outcome;
}

void SurfaceLight::addBlock(std::size_t light, const SampleBlocks& blocks,
                            const SampleBlocks::Block& block, std::size_t depth) {
  const ShaftLight& from = sights_.fine[light].shaftLight();
  const Known known{shaftAt(depth), followShaft(depth, light, from, blocks.targetsOf(block))};
  if (known.outcome != Shaft::Outcome::Unknown) return addSamples(light, blocks, block, known);
  for (const SampleBlocks::Block& part : blocks.partsOf(block))
    addBlock(light, blocks, part, depth + 1);
  if (block.parts > 0) return;
  if (from.radius == 0) return addSamples(light, blocks, block, known);
  forEachSample(blocks, block, [&](std::size_t index) {
    seen_[index] =
        seenFractionByShaft(sights_.fine[light], light, blocks.samples()[index], depth + 1);
  });
}

void SurfaceLight::addSamples(std::size_t light, const SampleBlocks& blocks,
                              const SampleBlocks::Block& block, const Known& known) {
  if (known.outcome == Shaft::Outcome::Dark && block.surface == id_) {
    costs_[light].samples += std::int64_t{block.columns} * block.rows;
    return;
  }
  forEachSample(blocks, block, [&](std::size_t index) {
    seen_[index] = seenFraction(sights_.fine[light], light, blocks.samples()[index], &known);
  });
}

double SurfaceLight::roughlySeenFraction(std::size_t light, const SamplePoint& at) {
  const LightSight& sight = sights_.rough[light];
  return seeing_ == Seeing::ByShafts ? seenFractionByShaft(sight, light, at, 0)
                                     : seenFraction(sight, light, at, nullptr);
}

/// By a shaft to one sample. Worth it for a ball, which takes many rays.
double SurfaceLight::seenFractionByShaft(const LightSight& sight, std::size_t light,
                                         const SamplePoint& at, std::size_t depth) {
  const ShaftTargets target{TargetBox::ofPoint(at.target, surface_.normal),
                            {&scene_[at.surface].sector, 1}};
  const Known known{shaftAt(depth), followShaft(depth, light, sight.shaftLight(), target)};
  return seenFraction(sight, light, at, &known);
}

bool SurfaceLight::isInReach(std::size_t light, const SamplePoint& at) const {
  const Vec3 toLight = scene_.level().lights[light].position - at.point;
  return dot(toLight, toLight) < sights_.reach[light] * sights_.reach[light];
}

Vec3 SurfaceLight::normalOf(SurfaceId surface) const { return surfaces_[surface.index()]->normal; }

double SurfaceLight::fullLevel(std::size_t index, const SamplePoint& at) const {
  const Vec3 toLight = light(index).position - at.point;
  const double distance = length(toLight);
  if (distance >= sights_.reach[index]) return 0;
  const double level = light(index).levelAt(distance);
  if (!lambert_) return level;
  // The middle of a ball can lie behind a plane that a part of it lights.
  return level * std::max(0.0, dot(toLight, normalOf(at.surface)) / distance);
}

const std::vector<double>& SurfaceLight::levels(std::size_t index, const SampleBlocks& blocks) {
  const LightKernels& kernels = lightKernels();
  const LightSource& source = light(index);
  const SampleArrays points = blocks.points();
  const std::size_t count = seen_.size();
  distances_.resize(count);
  levels_.resize(count);
  kernels.findDistances(points, count, source.position, distances_.data());
  if (source.curve.empty())
    kernels.findLevels(distances_.data(), count, source.intensity, source.falloff, levels_.data());
  else
    for (std::size_t i = 0; i < count; ++i)
      levels_[i] = seen_[i] > 0 ? source.levelAt(distances_[i]) : 0;
  if (lambert_)
    for (const auto& [surface, first, ofRun] : blocks.runs())
      kernels.applyCosine(points.from(first), &distances_[first], ofRun, source.position,
                          normalOf(surface), &levels_[first]);
  kernels.applySeen(seen_.data(), distances_.data(), count, sights_.reach[index], levels_.data());
  return levels_;
}

}  // namespace hearth
