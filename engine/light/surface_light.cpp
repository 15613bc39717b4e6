#include "light/surface_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/planted_bug.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether any of the light can shine on the plane of the surface. Of a ball that can be a part,
/// but none where its middle lies in the plane.
bool isInFront(const LightSource& light, double radius, const LitSurface& surface) {
  const double distance = surface.distanceInFront(light.position);
  if (planted(PlantedBug::LightInPlaneShines)) return distance > -kInPlane - radius;
  return std::abs(distance) > kInPlane && distance > -radius;
}

/// Corners of all that samples of the surface can lie on, but for tolerances.
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

/// Beams would hide these mistakes of rays.
bool isRayPlanted() {
  return planted(PlantedBug::LightThroughSteps) || planted(PlantedBug::LightStoppedBySky) ||
         planted(PlantedBug::LightThroughSlopes);
}

}  // namespace

SurfaceLight::SurfaceLight(const Level& level, const LitSurfaces& surfaces,
                           const LightSights& sights, bool lambert, SurfaceId id, Seeing seeing,
                           Trail* trail)
    : level_(level),
      surfaces_(surfaces),
      sights_(sights),
      surface_(*surfaces[id.index()]),
      id_(id),
      lambert_(lambert),
      seeing_(isRayPlanted() ? Seeing::ByRaysAlone : seeing),
      trail_(trail),
      placement_(surfaces, id, trail ? &trail->surfaces() : nullptr),
      costs_(level.lights.size()) {
  for (std::size_t i = 0; i < level.lights.size(); ++i)
    if (isInFront(level.lights[i], radiusOf(i), surface_) && reachesBox(i, cornersOf(surface_)))
      facing_.push_back(i);
}

double SurfaceLight::radiusOf(std::size_t light) const {
  return sights_.fine[light].beamLight().radius;
}

int SurfaceLight::channels() const {
  const auto isColored = [this](std::size_t i) { return light(i).isColored(); };
  return std::ranges::any_of(facing_, isColored) ? 3 : 1;
}

bool SurfaceLight::reachesBox(std::size_t light, std::span<const Vec3> corners) const {
  return distanceToBox(level_.lights[light].position, corners) <
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
  return {level_, surface_, std::move(samples), columns, rows};
}

double SurfaceLight::seenShare(const LightSight& sight, std::size_t index, const SamplePoint& at,
                               const Known* known) {
  const LitSurface& there = *surfaces_[at.surface.index()];
  // What continues a surface may lie a tolerance off its plane.
  if (at.surface != id_ && !isInFront(light(index), radiusOf(index), there)) return 0;
  LightCost& cost = costs_[index];
  ++cost.samples;
  if (!isInReach(index, at)) return 0;
  const LightTarget target{at.target, level_[at.surface].sector, {there.anchor, there.normal}};
  const double seen = known ? sight.seenShare(target, known->beam, known->outcome, cost.rays)
                            : sight.seenShare(target, cost.rays, metBy(index));
  if (seen > 0) ++cost.seenSamples;
  return seen;
}

const std::vector<double>& SurfaceLight::seenShares(std::size_t light, const SampleBlocks& blocks) {
  seen_.assign(blocks.samples().size(), 0);
  if (seeing_ == Seeing::ByBeams && sights_.fine[light].cones())
    addPointLight(light, blocks);
  else if (seeing_ == Seeing::ByBeams)
    addBlock(light, blocks, blocks.whole(), 0);
  else
    for (std::size_t i = 0; i < seen_.size(); ++i) seen_[i] = seenShare(light, blocks.samples()[i]);
  return seen_;
}

double SurfaceLight::seenShare(std::size_t light, const SamplePoint& at) {
  return seenShare(sights_.fine[light], light, at, nullptr);
}

const Segment* SurfaceLight::wallOf(SurfaceId surface) const {
  const Surface& there = level_.surfaces[surface.index()];
  return there.segment ? &level_[*there.segment] : nullptr;
}

/// Of points that are lit, or may lie in those of `cones_` from `first` on.
SurfaceLight::ByCones SurfaceLight::byCones(SurfaceId surface, bool areLit,
                                            std::size_t first) const {
  const bool areDark = !areLit && first == cones_.size();
  const Beam::Outcome outcome = areLit    ? Beam::Outcome::Lit
                                : areDark ? Beam::Outcome::Dark
                                          : Beam::Outcome::Unknown;
  return {surface, outcome, true, first, cones_.size()};
}

SurfaceLight::ByCones SurfaceLight::findCones(std::size_t light, SurfaceId surface,
                                              std::span<const Vec3> corners) {
  const LightCones& cones = *sights_.fine[light].cones();
  const SectorId sector = level_[surface].sector;
  const LitSurface& there = *surfaces_[surface.index()];
  const LightCones::Points points = cones.seen(corners);
  const std::size_t first = cones_.size();
  if (!cones.knows(sector, {there.anchor, there.normal}, points))
    return {surface, Beam::Outcome::Unknown, false, first, first};
  return byCones(surface, cones.find(sector, wallOf(surface), points, cones_), first);
}

/// Of points among those that `before` is about.
SurfaceLight::ByCones SurfaceLight::narrowed(std::size_t light, const ByCones& before,
                                             std::span<const Vec3> corners) {
  if (!before.isKnown || before.outcome != Beam::Outcome::Unknown) return before;
  const LightCones& cones = *sights_.fine[light].cones();
  const std::size_t first = cones_.size();
  const bool isLit =
      cones.narrow(cones.seen(corners), wallOf(before.surface), cones_, before.first, before.last);
  return byCones(before.surface, isLit, first);
}

void SurfaceLight::dropConesFrom(std::size_t first) {
  cones_.erase(cones_.begin() + static_cast<std::ptrdiff_t>(first), cones_.end());
}

void SurfaceLight::addPointLight(std::size_t light, const SampleBlocks& blocks) {
  const SampleBlocks::Block& whole = blocks.whole();
  if (trail_) followBeam(0, light, sights_.fine[light].beamLight(), blocks.targetsOf(whole));
  cones_.clear();
  surfacesByCones_.clear();
  for (const SurfaceId surface : blocks.surfaces())
    surfacesByCones_.push_back(findCones(light, surface, whole.box.corners()));
  addByCones(light, blocks, whole, nullptr);
}

/// `around`, if any, is of samples that these are among, all on one surface.
void SurfaceLight::addByCones(std::size_t light, const SampleBlocks& blocks,
                              const SampleBlocks::Block& block, const ByCones* around) {
  const auto wholeOf = [&](SurfaceId surface) -> const ByCones& {
    return *std::ranges::find(surfacesByCones_, surface, &ByCones::surface);
  };
  const std::size_t before = cones_.size();
  std::optional<ByCones> here;
  if (block.surface) {
    here = narrowed(light, around ? *around : wholeOf(*block.surface), block.box.corners());
    if (!here->isKnown) return addBlock(light, blocks, block, 0);
    if (here->outcome != Beam::Outcome::Unknown) {
      dropConesFrom(before);
      return addSamples(light, blocks, block, {beamAt(0), here->outcome});
    }
  }
  for (const SampleBlocks::Block& part : blocks.partsOf(block))
    addByCones(light, blocks, part, here ? &*here : nullptr);
  if (block.parts == 0)
    forEachSample(blocks, block, [&](std::size_t index) {
      const SamplePoint& at = blocks.samples()[index];
      seen_[index] = seenShareByCones(light, at, here ? *here : wholeOf(at.surface));
    });
  dropConesFrom(before);
}

double SurfaceLight::seenShareByCones(std::size_t light, const SamplePoint& at,
                                      const ByCones& around) {
  const std::size_t before = cones_.size();
  const Known known{beamAt(0), narrowed(light, around, {&at.target, 1}).outcome};
  dropConesFrom(before);
  return seenShare(sights_.fine[light], light, at,
                   known.outcome == Beam::Outcome::Unknown ? nullptr : &known);
}

Beam& SurfaceLight::beamAt(std::size_t depth) {
  while (beams_.size() <= depth) beams_.emplace_back(level_);
  return beams_[depth];
}

/// Within that of less depth, if there is one.
Beam::Outcome SurfaceLight::followBeam(std::size_t depth, std::size_t light, const BeamLight& from,
                                       const BeamTargets& targets) {
  Beam& beam = beamAt(depth);
  if (depth > 0) return beam.follow(from, targets, &beams_[depth - 1]);
  const Beam::Outcome outcome = beam.follow(from, targets, nullptr);
  if (SectorSet* met = metBy(light)) beam.addSectorsTo(*met);
  return outcome;
}

void SurfaceLight::addBlock(std::size_t light, const SampleBlocks& blocks,
                            const SampleBlocks::Block& block, std::size_t depth) {
  const BeamLight& from = sights_.fine[light].beamLight();
  const Known known{beamAt(depth), followBeam(depth, light, from, blocks.targetsOf(block))};
  if (known.outcome != Beam::Outcome::Unknown) return addSamples(light, blocks, block, known);
  for (const SampleBlocks::Block& part : blocks.partsOf(block))
    addBlock(light, blocks, part, depth + 1);
  if (block.parts > 0) return;
  if (from.radius == 0) return addSamples(light, blocks, block, known);
  forEachSample(blocks, block, [&](std::size_t index) {
    seen_[index] = seenShareByBeam(sights_.fine[light], light, blocks.samples()[index], depth + 1);
  });
}

void SurfaceLight::addSamples(std::size_t light, const SampleBlocks& blocks,
                              const SampleBlocks::Block& block, const Known& known) {
  if (known.outcome == Beam::Outcome::Dark && block.surface == id_) {
    costs_[light].samples += std::int64_t{block.columns} * block.rows;
    return;
  }
  forEachSample(blocks, block, [&](std::size_t index) {
    seen_[index] = seenShare(sights_.fine[light], light, blocks.samples()[index], &known);
  });
}

double SurfaceLight::roughlySeenShare(std::size_t light, const SamplePoint& at) {
  const LightSight& sight = sights_.rough[light];
  return seeing_ == Seeing::ByBeams ? seenShareByBeam(sight, light, at, 0)
                                    : seenShare(sight, light, at, nullptr);
}

/// By a beam to one sample. Worth it for a ball, which takes many rays.
double SurfaceLight::seenShareByBeam(const LightSight& sight, std::size_t light,
                                     const SamplePoint& at, std::size_t depth) {
  const BeamTargets target{TargetBox::ofPoint(at.target, surface_.normal),
                           {&level_[at.surface].sector, 1}};
  const Known known{beamAt(depth), followBeam(depth, light, sight.beamLight(), target)};
  return seenShare(sight, light, at, &known);
}

bool SurfaceLight::isInReach(std::size_t light, const SamplePoint& at) const {
  const Vec3 way = level_.lights[light].position - at.point;
  return dot(way, way) < sights_.reach[light] * sights_.reach[light];
}

double SurfaceLight::fullLevel(std::size_t index, const SamplePoint& at) const {
  const Vec3 toLight = light(index).position - at.point;
  const double distance = length(toLight);
  if (distance >= sights_.reach[index]) return 0;
  const double level = light(index).levelAt(distance);
  if (!lambert_) return level;
  const Vec3 normal = planted(PlantedBug::CosineOfWrongNormal)
                          ? Vec3{0, 0, 1}
                          : surfaces_[at.surface.index()]->normal;
  const double inFront = dot(toLight, normal);
  // The middle of a ball can lie behind a plane that a part of it lights.
  return level * std::max(0.0, inFront / distance);
}

}  // namespace hearth
