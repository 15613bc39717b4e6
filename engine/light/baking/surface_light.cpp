#include "light/baking/surface_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "light/baking/brightness_kernels.h"
#include "light/baking/unshadowed_brightness.h"
#include "math/box3.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

Box3 boxAround(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3 p : points) box.add(p);
  return box;
}

}  // namespace

std::vector<std::size_t> lightsFacing(const Scene& scene, const LightReach& reach,
                                      const LitSurface& surface) {
  std::vector<std::size_t> lights = reach.reaching(boxAround(surface, surface.texels));
  std::erase_if(lights, [&](std::size_t i) { return !isInFront(scene, reach, i, surface); });
  return lights;
}

SurfaceLight::SurfaceLight(const Scene& scene, const LitSurfaces& surfaces,
                           const LightVisibilities& visibilities, bool lambert, SurfaceId id,
                           VisibilityMethod method, LightDependencies* dependencies)
    : SurfacePlaces(scene, surfaces, id, dependencies),
      lambert_(lambert),
      method_(method),
      rays_(scene, surfaces, visibilities, id, dependencies),
      shafts_(rays_),
      beams_(rays_, shafts_),
      suns_(rays_),
      areas_(rays_, *this),
      facing_(lightsFacing(scene, visibilities.reach, surface())) {}

int SurfaceLight::channels() const {
  const auto isColored = [this](std::size_t i) { return light(i).isColored(); };
  return std::ranges::any_of(facing_, isColored) ? 3 : 1;
}

std::vector<std::size_t> SurfaceLight::facing(const TexelRect& texels) const {
  return rays_.visibilities().reach.reaching(boxAround(surface(), texels), facing_);
}

std::vector<std::size_t> SurfaceLight::reaching(const SampleBlocks& blocks,
                                                std::span<const std::size_t> lights) const {
  return rays_.visibilities().reach.reaching(boxAround(blocks.boxOf(blocks.whole()).corners()),
                                             lights);
}

SampleBlocks SurfaceLight::inBlocks(std::vector<SamplePoint> samples, int columns) const {
  return {rays_.scene().level(), surface(), std::move(samples), columns};
}

const std::vector<double>& SurfaceLight::seenFractions(std::size_t light,
                                                       const SampleBlocks& blocks) {
  seen_.assign(blocks.samples().size(), 0);
  if (method_ == VisibilityMethod::Shafts)
    findSeen(light, blocks);
  else
    for (std::size_t i = 0; i < seen_.size(); ++i)
      if (const SamplePoint& at = blocks.samples()[i]; !at.isSpare)
        seen_[i] = seenFraction(light, at);
  return seen_;
}

void SurfaceLight::findSeen(std::size_t light, const SampleBlocks& blocks) {
  if (rays_.light(light).isArea())
    areas_.find(light, blocks, seen_);
  else if (rays_.sun(light))
    suns_.find(light, blocks, seen_);
  else if (rays_.visibility(light).beams())
    beams_.find(light, blocks, seen_);
  else
    shafts_.find(light, blocks, blocks.whole(), seen_);
}

double SurfaceLight::seenFraction(std::size_t light, const SamplePoint& at) {
  if (rays_.light(light).isArea()) return areas_.seenFraction(light, at);
  if (const SunVisibility* sun = rays_.sun(light))
    return rays_.seenFraction(*sun, light, at, nullptr);
  return rays_.seenFraction(rays_.visibility(light), light, at, nullptr);
}

double SurfaceLight::roughlySeenFraction(std::size_t light, const SamplePoint& at) {
  if (rays_.light(light).isArea()) return areas_.seenFraction(light, at);
  if (rays_.sun(light))
    return rays_.seenFraction(rays_.visibilities().roughSun(light), light, at, nullptr);
  const LightVisibility& visibility = rays_.roughVisibility(light);
  return method_ == VisibilityMethod::Shafts ? shafts_.seenFraction(visibility, light, at)
                                             : rays_.seenFraction(visibility, light, at, nullptr);
}

double SurfaceLight::unshadowedBrightness(std::size_t index, const SamplePoint& at) const {
  return hearth::unshadowedBrightness(light(index), rays_.reach(index), at.point,
                                      rays_.surface(at.surface).normal, lambert_);
}

const std::vector<double>& SurfaceLight::brightness(std::size_t index, const SampleBlocks& blocks) {
  const std::size_t count = seen_.size();
  distances_.resize(count);
  brightness_.resize(count);
  findLevels(index, blocks);
  brightnessKernels().applySeen(seen_.data(), distances_.data(), count, rays_.reach(index),
                                brightness_.data());
  return brightness_;
}

/// Of samples that see all of the light, and their distances from it.
void SurfaceLight::findLevels(std::size_t index, const SampleBlocks& blocks) {
  const LightSource& source = light(index);
  const BrightnessKernels& kernels = brightnessKernels();
  const SampleArrays points = blocks.points();
  const std::size_t count = seen_.size();
  if (!source.hasPlace()) {
    std::ranges::fill(distances_, 0);
    for (const auto& [surface, first, ofRun] : blocks.runs())
      std::fill_n(brightness_.begin() + static_cast<std::ptrdiff_t>(first), ofRun,
                  hearth::unshadowedBrightness(source, rays_.reach(index), {},
                                               rays_.surface(surface).normal, lambert_));
    return;
  }
  kernels.findDistances(points, count, source.position, distances_.data());
  if (source.curve.empty())
    kernels.findLevels(distances_.data(), count, source.intensity, source.falloff,
                       brightness_.data());
  else
    kernels.findLevelsOnCurve(distances_.data(), count, source.curve, brightness_.data());
  if (source.spot)
    kernels.applySpot(points, distances_.data(), count, source.position, *source.spot,
                      brightness_.data());
  if (lambert_)
    for (const auto& [surface, first, ofRun] : blocks.runs())
      kernels.applyCosine(points.from(first), &distances_[first], ofRun, source.position,
                          rays_.surface(surface).normal, &brightness_[first]);
}

}  // namespace hearth
