#include "light/baking/patch_light.h"

#include <algorithm>
#include <optional>

#include "light/baking/sample_rays.h"
#include "light/baking/unshadowed_brightness.h"
#include "light/rays/raytracer.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Whether more arrives than rounding.
bool arrives(double fraction) { return fraction > 1e-9; }

/// Metres from a point to the nearest of a patch, or less.
double distanceTo(const LitSurface& patch, Vec3 from) {
  const TexelRect& rect = patch.texels;
  const Vec2 at = patch.grid.toTexels(from);
  const Vec2 nearest{std::clamp<double>(at.x, rect.i0, rect.i0 + rect.width),
                     std::clamp<double>(at.y, rect.j0, rect.j0 + rect.height)};
  return length(patch.toWorld(nearest) - from);
}

}  // namespace

PatchLight::PatchLight(const Scene& scene, const LightVisibilities& visibilities, bool lambert,
                       const MeshPlace& place, const LitSurfaces& patch)
    : PatchPlaces(scene, place.sectors, patch),
      scene_(scene),
      visibilities_(visibilities),
      lambert_(lambert),
      place_(place),
      shafts_(scene, visibilities, boxOf(*patch.front()), place),
      costs_(scene.lights().size()) {
  for (const std::size_t i : place.lights.lights())
    if (isInFront(scene, visibilities.reach, i, surface()) &&
        distanceTo(surface(), light(i).position) < visibilities.reach.metres(i) + kAuthorNoise)
      facing_.push_back(i);
}

int PatchLight::channels() const {
  const auto isColored = [this](std::size_t i) { return light(i).isColored(); };
  return std::ranges::any_of(facing_, isColored) ? 3 : 1;
}

const std::vector<double>& PatchLight::seenFractions(std::size_t light,
                                                     const PatchSamples& samples) {
  seen_.clear();
  for (const SamplePoint& at : samples.samples())
    seen_.push_back(at.isSpare ? 0 : seenFraction(light, at));
  return seen_;
}

double PatchLight::seenFraction(const LightVisibility& visibility, std::size_t index,
                                const SamplePoint& at) {
  LightCost& cost = costs_[index];
  ++cost.samples;
  if (length(light(index).position - at.point) >= visibilities_.reach.metres(index) ||
      !visibilities_.reach.isInSpot(index, at.point))
    return 0;
  const auto& [shaft, outcome] = shafts_.toPoint(index, at.target, surface().normal);
  const double seen = visibility.seenFraction(facePointAt(at), shaft, outcome, cost.rays);
  if (seen > 0) ++cost.seenSamples;
  return seen;
}

double PatchLight::seenFraction(const SunVisibility& sun, std::size_t index,
                                const SamplePoint& at) {
  LightCost& cost = costs_[index];
  ++cost.samples;
  const std::optional<SectorId> sector = sectorAround(scene_, place_.sectors, at.target);
  if (!sector) return 0;
  const double seen =
      sun.seenFraction(facePointAt(at), *sector, place_.lights.shaftTowards(index), cost.rays);
  if (seen > 0) ++cost.seenSamples;
  return seen;
}

AreaLattice& PatchLight::areas() {
  if (!areas_)
    areas_.emplace(scene_, visibilities_, *this,
                   [this](const SamplePoint& at, AreaVisibility& areas, std::span<double> fractions,
                          std::int64_t& slices, SectorSet& met) {
                     const auto sector = sectorAround(scene_, place_.sectors, at.target);
                     if (!sector) return false;
                     const Vec3 normal = surface().normal;
                     areas.findOnMesh(at.target, *sector, {&normal, 1}, fractions, slices, &met);
                     return std::ranges::any_of(fractions, arrives) ||
                            !isInsideMesh(at.target, *sector, met);
                   });
  return *areas_;
}

/// Whether another part of a mesh, as a board on a crate, covers a point of the patch. What is dark
/// there tells nothing of the places around it.
bool PatchLight::isInsideMesh(Vec3 point, SectorId sector, SectorSet& met) const {
  const Vec3 normal = surface().normal;
  return Raytracer(scene_).isInsideMesh(point + kPositionSlack * normal, normal, sector, &met);
}

double PatchLight::unshadowedBrightness(std::size_t index, const SamplePoint& at) const {
  return hearth::unshadowedBrightness(light(index), visibilities_.reach.metres(index), at.point,
                                      surface().normal, lambert_);
}

const std::vector<double>& PatchLight::brightness(std::size_t light, const PatchSamples& samples) {
  brightness_.clear();
  for (std::size_t i = 0; i < seen_.size(); ++i)
    brightness_.push_back(
        seen_[i] > 0 ? seen_[i] * unshadowedBrightness(light, samples.samples()[i]) : 0);
  return brightness_;
}

}  // namespace hearth
