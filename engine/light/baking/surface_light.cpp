#include "light/baking/surface_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "light/baking/brightness_kernels.h"
#include "light/baking/unshadowed_brightness.h"
#include "light/rays/raytracer.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

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

}  // namespace

bool mayHaveSamplesInMeshes(const Scene& scene, const LitSurfaces& surfaces, SurfaceId id) {
  if (scene.level().meshes.empty()) return false;
  // A sample lies on no surface that is farther away than a few others.
  constexpr std::size_t kMany = 64;
  std::vector<SurfaceId> reached{id};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (i > kMany || !scene.level().meshesIn(scene[reached[i]].sector).empty()) return true;
    for (const Continuation& next : surfaces[reached[i].index()]->continuations)
      if (std::ranges::find(reached, next.surface) == reached.end())
        reached.push_back(next.surface);
  }
  return false;
}

SurfaceLight::SurfaceLight(const Scene& scene, const LitSurfaces& surfaces,
                           const LightVisibilities& visibilities, bool lambert, SurfaceId id,
                           VisibilityMethod method, LightDependencies* dependencies)
    : surface_(*surfaces[id.index()]),
      lambert_(lambert),
      method_(method),
      placement_(surfaces, id, dependencies ? &dependencies->surfaces() : nullptr),
      rays_(scene, surfaces, visibilities, id, dependencies),
      shafts_(rays_),
      beams_(rays_, shafts_),
      mayLeaveOut_(mayHaveSamplesInMeshes(scene, surfaces, id)) {
  for (std::size_t i = 0; i < scene.level().lights.size(); ++i)
    if (isInFront(light(i), radiusOf(i), surface_) && reachesBox(i, cornersOf(surface_)))
      facing_.push_back(i);
}

bool SurfaceLight::isLeftOut(const SamplePoint& at) const {
  return Raytracer(rays_.scene())
      .isInsideMesh(at.target, rays_.surface(at.surface).normal, rays_.scene()[at.surface].sector);
}

int SurfaceLight::channels() const {
  const auto isColored = [this](std::size_t i) { return light(i).isColored(); };
  return std::ranges::any_of(facing_, isColored) ? 3 : 1;
}

bool SurfaceLight::reachesBox(std::size_t light, std::span<const Vec3> corners) const {
  return distanceToBox(rays_.light(light).position, corners) < rays_.reach(light) + kAuthorNoise;
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
  return {rays_.scene().level(), surface_, std::move(samples), columns, rows};
}

const std::vector<double>& SurfaceLight::seenFractions(std::size_t light,
                                                       const SampleBlocks& blocks) {
  seen_.assign(blocks.samples().size(), 0);
  if (method_ == VisibilityMethod::Shafts && rays_.visibility(light).beams())
    beams_.find(light, blocks, seen_);
  else if (method_ == VisibilityMethod::Shafts)
    shafts_.find(light, blocks, blocks.whole(), seen_);
  else
    for (std::size_t i = 0; i < seen_.size(); ++i)
      seen_[i] = seenFraction(light, blocks.samples()[i]);
  return seen_;
}

double SurfaceLight::seenFraction(std::size_t light, const SamplePoint& at) {
  return rays_.seenFraction(rays_.visibility(light), light, at, nullptr);
}

double SurfaceLight::roughlySeenFraction(std::size_t light, const SamplePoint& at) {
  const LightVisibility& visibility = rays_.roughVisibility(light);
  return method_ == VisibilityMethod::Shafts ? shafts_.seenFraction(visibility, light, at)
                                             : rays_.seenFraction(visibility, light, at, nullptr);
}

double SurfaceLight::unshadowedBrightness(std::size_t index, const SamplePoint& at) const {
  return hearth::unshadowedBrightness(light(index), rays_.reach(index), at.point,
                                      rays_.surface(at.surface).normal, lambert_);
}

const std::vector<double>& SurfaceLight::brightness(std::size_t index, const SampleBlocks& blocks) {
  const BrightnessKernels& kernels = brightnessKernels();
  const LightSource& source = light(index);
  const SampleArrays points = blocks.points();
  const std::size_t count = seen_.size();
  distances_.resize(count);
  brightness_.resize(count);
  kernels.findDistances(points, count, source.position, distances_.data());
  if (source.curve.empty())
    kernels.findLevels(distances_.data(), count, source.intensity, source.falloff,
                       brightness_.data());
  else
    for (std::size_t i = 0; i < count; ++i)
      brightness_[i] = seen_[i] > 0 ? source.brightnessAt(distances_[i]) : 0;
  if (lambert_)
    for (const auto& [surface, first, ofRun] : blocks.runs())
      kernels.applyCosine(points.from(first), &distances_[first], ofRun, source.position,
                          rays_.surface(surface).normal, &brightness_[first]);
  kernels.applySeen(seen_.data(), distances_.data(), count, rays_.reach(index), brightness_.data());
  return brightness_;
}

}  // namespace hearth
