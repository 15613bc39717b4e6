#include "agreement/texel_truth.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "agreement/curve_miss.h"
#include "level/locate.h"

namespace hearth::agreement {

namespace {

/// Metres around a sample. One on an edge is taken a micrometre inside it, and in a corner the
/// format does not say which way: two that are both right lie less than two of these apart. Where
/// several corners of a surface meet, as where a hole touches the border, it does not say in which:
/// all are tried. Elsewhere only rounding moves a sample: that of coordinates, and the 10^-7 m that
/// the bakery leaves before it. Where many pixels are excused, a light, a wall and a row of samples
/// are in one line: 413 pixels of a sloped floor of seed 1949, where that line is y = 2.125.
constexpr std::array kHairs{1e-6, 2e-6};
constexpr double kStep = 0.25;  ///< levels: more is an edge of a shadow or a jump

/// Points so far from one along the axes and between them.
std::vector<Vec3> ballAround(Vec3 center, double radiusMetres) {
  std::vector<Vec3> points;
  for (const double x : {-1, 0, 1})
    for (const double y : {-1, 0, 1})
      for (const double z : {-1, 0, 1}) {
        const Vec3 direction{x, y, z};
        const double size = length(direction);
        if (size > 0) points.push_back(center + radiusMetres / size * direction);
      }
  return points;
}

/// Of the samples around a point, as interpolation takes them to lie.
std::vector<WeightedDistance> distancesTo(const LightSource& light, const PatchLight& patch) {
  std::vector<WeightedDistance> places;
  for (std::size_t k = 0; k < 4; ++k)
    for (const TexelSample& sample : patch.texels[k]->samples)
      places.push_back({length(light.position - sample.center),
                        patch.weights[k] / static_cast<double>(patch.texels[k]->samples.size())});
  return places;
}

/// Whether all places of a patch get all of a spot's light, or all get none.
bool isSpotEven(const LightSource& light, const PatchLight& patch, const SurfacePoint& hit) {
  const auto factorAt = [&](Vec3 p) { return light.spot->factor(p - light.position); };
  const double here = factorAt(hit.point);
  const auto isSame = [&](const TexelSample& sample) {
    return factorAt(sample.place.point) == here;
  };
  return (here == 0 || here == 1) &&
         std::ranges::all_of(patch.texels, [&](const TexelLight* texel) {
           return std::ranges::all_of(texel->samples, isSame);
         });
}

}  // namespace

double PatchLight::interpolated(std::size_t channel) const {
  double level = 0;
  for (std::size_t k = 0; k < 4; ++k)
    level += weights[k] * std::min(texels[k]->levels[channel], 255.0);
  return level;
}

bool PatchLight::clipsBetween(std::size_t channel) const {
  const auto clipped = std::ranges::count_if(
      texels, [&](const TexelLight* texel) { return texel->levels[channel] > 255; });
  return clipped != 0 && clipped != 4;
}

bool PatchLight::lacksSamples() const {
  return std::ranges::any_of(texels, &TexelLight::lacksSamples);
}

TexelTruth::TexelTruth(const Scene& scene)
    : scene_(scene), level_(scene.level()), truth_(level_), texels_(scene) {}

std::optional<PatchLight> TexelTruth::around(const SurfacePoint& hit) {
  const std::optional<TexelPatch> patch = texels_.around(hit);
  if (!patch) return std::nullopt;
  PatchLight light{{}, patch->weights};
  for (std::size_t k = 0; k < 4; ++k) light.texels[k] = &lightOf(patch->texels[k]);
  return light;
}

Channels TexelTruth::at(const SurfacePoint& place) const {
  const Vec3 levels = truth_.at(place);
  return {levels.x, levels.y, levels.z};
}

Channels TexelTruth::at(const AirPoint& place) const {
  const Vec3 levels = truth_.at(place);
  return {levels.x, levels.y, levels.z};
}

const TexelLight& TexelTruth::lightOf(const Texel& texel) {
  const auto [entry, isNew] = lights_.try_emplace(texel);
  TexelLight& light = entry->second;
  if (!isNew) return light;
  light.texel = texel;
  if (texels_.isFourthOfSmallFace(texel)) {
    light.levels = fourthOf(texel);
    return light;
  }
  light.samples = texels_.samplesOf(texel);
  light.lacksSamples = !texels_.hasAllSamples(texel);
  if (light.samples.empty()) light.samples = texels_.samplesOf(texels_.nearestWithSamples(texel));
  const auto count = static_cast<double>(light.samples.size());
  for (const TexelSample& sample : light.samples) {
    std::vector<bool>& sees = light.sees.emplace_back(level_.lights.size());
    for (std::size_t i = 0; i < sees.size(); ++i) {
      sees[i] = truth_.seenFraction(i, sample.place) > 0;
      if (sees[i]) add(light.levels, i, truth_.unshaded(i, sample.place) / count);
    }
  }
  return light;
}

/// Of bytes.
Channels TexelTruth::fourthOf(const Texel& texel) {
  const auto at = [&](double i, double j, std::size_t channel) {
    const double level = lightOf({texel.surface, texel.piece, i, j}).levels[channel];
    return std::floor(std::clamp(level, 0.0, 255.0) + 0.5);
  };
  Channels levels;
  for (std::size_t channel = 0; channel < 3; ++channel)
    levels[channel] = std::max(0.0, at(1, 0, channel) + at(0, 1, channel) - at(0, 0, channel));
  return levels;
}

void TexelTruth::add(Channels& sum, std::size_t light, double level) const {
  for (int channel = 0; channel < 3; ++channel)
    sum[static_cast<std::size_t>(channel)] += level * level_.lights[light].colorFactor(channel);
}

Channels TexelTruth::hairSlack(const PatchLight& patch) {
  const auto isInDoubt = [&](const TexelLight* texel) { return texels_.isInDoubt(texel->texel); };
  if (std::ranges::any_of(patch.texels, isInDoubt)) return {255, 255, 255};
  Channels slack{};
  for (std::size_t k = 0; k < 4; ++k)
    for (const TexelSample& sample : patch.texels[k]->samples) {
      const Channels step = stepAround(sample);
      const auto count = static_cast<double>(patch.texels[k]->samples.size());
      for (std::size_t channel = 0; channel < 3; ++channel)
        slack[channel] += patch.weights[k] / count * step[channel];
    }
  return slack;
}

/// Of each light the greatest difference to a hair away from where the sample may lie, where that
/// is a step: what one of them gains another may lose.
Channels TexelTruth::stepAround(const TexelSample& sample) {
  std::vector<SurfacePoint> centers = sample.others;
  centers.push_back(sample.place);
  std::vector<SurfacePoint> places = centers;
  for (const double hair : kHairs)
    for (const SurfacePoint& center : centers)
      std::ranges::copy(texels_.ringAround(center, hair), std::back_inserter(places));
  Channels steps{};
  for (std::size_t i = 0; i < level_.lights.size(); ++i) {
    const double here = truth_.from(i, sample.place);
    // Beyond the edge of the surface, where no ring leads, light may be another, too.
    double greatest = jumpOfSpot(level_.lights[i], sample.place.point, kHairs.back());
    for (const SurfacePoint& place : places)
      greatest = std::max(greatest, std::abs(truth_.from(i, place) - here));
    if (greatest > kStep) add(steps, i, greatest);
  }
  return steps;
}

Channels TexelTruth::hairSlack(const AirPoint& place) const {
  Channels steps{};
  for (std::size_t i = 0; i < level_.lights.size(); ++i) {
    const double here = truth_.from(i, place);
    double greatest = 0;
    for (const double hair : kHairs)
      for (const Vec3 p : ballAround(place.point, hair))
        if (contains(scene_, level_[place.sector], p, 0))
          greatest = std::max(greatest, std::abs(truth_.from(i, AirPoint{p, place.sector}) - here));
    if (greatest > kStep) add(steps, i, greatest);
  }
  return steps;
}

bool TexelTruth::isAtJump(const PatchLight& patch) const {
  for (const TexelLight* texel : patch.texels)
    for (std::size_t k = 0; k < texel->samples.size(); ++k)
      for (std::size_t i = 0; i < level_.lights.size(); ++i) {
        const LightSource& light = level_.lights[i];
        const double distance = length(light.position - texel->samples[k].place.point);
        const double hair = kHairs.back();
        if (!texel->sees[k][i]) continue;
        if (jumpsBetween(light.curve, distance - hair, distance + hair) > kStep) return true;
        if (jumpOfSpot(light, texel->samples[k].place.point, hair) > kStep) return true;
      }
  return false;
}

bool TexelTruth::seesAlike(const PatchLight& patch, const SurfacePoint& hit) const {
  for (std::size_t i = 0; i < level_.lights.size(); ++i) {
    const bool seen = truth_.seenFraction(i, hit) > 0;
    for (const TexelLight* texel : patch.texels)
      for (const std::vector<bool>& sees : texel->sees)
        if (sees[i] != seen) return false;
  }
  return true;
}

Channels TexelTruth::missAtCurves(const PatchLight& patch, const SurfacePoint& hit) const {
  Channels miss{};
  for (std::size_t i = 0; i < level_.lights.size(); ++i) {
    const LightSource& light = level_.lights[i];
    if (!patch.texels[0]->sees[0][i]) continue;
    const double here = length(light.position - hit.point);
    if (light.spot && !isSpotEven(light, patch, hit))
      add(miss, i, light.brightnessAt(here) * missOfSpot(*light.spot, here, level_.bake.texel));
    if (light.curve.empty()) continue;
    const std::vector<WeightedDistance> places = distancesTo(light, patch);
    const auto [nearest, farthest] = std::ranges::minmax(places, {}, &WeightedDistance::metres);
    add(miss, i,
        jumpsBetween(light.curve, std::min(here, nearest.metres), std::max(here, farthest.metres)) +
            missAtBends(light.curve, places) + missOfSlope(light.curve, here, level_.bake.texel));
  }
  return miss;
}

Channels TexelTruth::missBeyondEdge(const PatchLight& patch) const {
  Channels miss{};
  for (std::size_t k = 0; k < 4; ++k) {
    const TexelLight& texel = *patch.texels[k];
    const double weight = patch.weights[k] / static_cast<double>(texel.samples.size());
    for (std::size_t s = 0; s < texel.samples.size(); ++s) {
      const SurfacePoint& place = texel.samples[s].place;
      SurfacePoint center = place;
      center.point = texel.samples[s].center;
      for (std::size_t i = 0; i < level_.lights.size(); ++i)
        if (texel.sees[s][i])
          add(miss, i, weight * std::abs(truth_.unshaded(i, center) - truth_.unshaded(i, place)));
    }
  }
  return miss;
}

}  // namespace hearth::agreement
