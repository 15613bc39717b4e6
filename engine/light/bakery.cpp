#include "light/bakery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "light/light_sight.h"
#include "light/light_sum.h"
#include "light/parallel.h"
#include "light/sample_placement.h"
#include "math/planted_bug.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// The map itself, or with one channel where no coloured light arrived.
Lightmap withoutNeedlessChannels(Lightmap map) {
  if (map.channels == 1) return map;
  const std::size_t texels = map.levels.size() / 3;
  const auto texel = [&](std::size_t i) { return std::span(map.levels).subspan(3 * i, 3); };
  for (std::size_t i = 0; i < texels; ++i)
    if (texel(i)[0] != texel(i)[1] || texel(i)[1] != texel(i)[2]) return map;
  Lightmap white{map.rect, {}, 1};
  white.levels.reserve(texels);
  for (std::size_t i = 0; i < texels; ++i) white.levels.push_back(texel(i)[0]);
  return white;
}

/// Whether any of the light can shine on the plane of the surface.
bool isInFront(const LightSource& light, const LitSurface& surface) {
  const double least = planted(PlantedBug::LightInPlaneShines) ? -kInPlane : kInPlane;
  return surface.distanceInFront(light.position) > least - light.radius;
}

/// Traces the light on single samples of one surface.
class SurfaceBaker {
 public:
  SurfaceBaker(const Level& level, const LitSurfaces& surfaces,
               const std::vector<LightSight>& sights, const BakeSettings& settings, SurfaceId id)
      : level_(level),
        sights_(sights),
        settings_(settings),
        surfaces_(surfaces),
        surface_(*surfaces[id.index()]),
        id_(id),
        kind_(level[id].kind),
        placement_(surfaces, id) {
    for (std::size_t i = 0; i < level.lights.size(); ++i)
      if (isInFront(level.lights[i], surface_)) facing_.push_back(i);
    const auto isColored = [&](std::size_t i) { return level.lights[i].isColored(); };
    channels_ = std::ranges::any_of(facing_, isColored) ? 3 : 1;
  }

  /// None where no light reaches the surface.
  std::optional<Lightmap> bake() {
    if (facing_.empty() || isPlantedUnlit()) return std::nullopt;
    const TexelRect rect = surface_.texels;
    Lightmap map{rect, {}, channels_};
    map.levels.reserve(static_cast<std::size_t>(rect.width) *
                       static_cast<std::size_t>(rect.height) * static_cast<std::size_t>(channels_));
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i) addTexel(i, j, map.levels);
    if (std::ranges::all_of(map.levels, [](std::uint8_t level) { return level == 0; }))
      return std::nullopt;
    return withoutNeedlessChannels(std::move(map));
  }

  std::int64_t rays() const { return rays_; }

 private:
  bool isPlantedUnlit() const {
    return (planted(PlantedBug::SidewallsUnlit) && isSidewall(kind_)) ||
           (planted(PlantedBug::LowerStepsUnlit) && kind_ == SurfaceKind::LowerStep);
  }

  using Sums = std::array<LightSum, 3>;  ///< by channel, of which `channels_` count

  void addTexel(int i, int j, std::vector<std::uint8_t>& levels) {
    const int side = static_cast<int>(std::lround(std::sqrt(settings_.samples)));
    Sums sums;
    for (int b = 0; b < side; ++b)
      for (int a = 0; a < side; ++a) addSample({i + (a + 0.5) / side, j + (b + 0.5) / side}, sums);
    for (int channel = 0; channel < channels_; ++channel)
      levels.push_back(sums[static_cast<std::size_t>(channel)].mean(side * side));
  }

  void addSample(Vec2 texelPoint, Sums& sums) {
    if (planted(PlantedBug::BorderTexelsBlack) && !surface_.contains(texelPoint)) return;
    const SamplePoint at = placement_.place(texelPoint);
    const LitSurface& there = *surfaces_[at.surface.index()];
    for (const std::size_t i : facing_) {
      const LightSource& light = level_.lights[i];
      // What continues a surface may lie a tolerance off its plane.
      if (at.surface != id_ && !isInFront(light, there)) continue;
      const double seen = sights_[i].seenShare(
          {at.target, level_[at.surface].sector, {there.anchor, there.normal}}, rays_);
      if (seen == 0) continue;
      const double level = seen * levelFrom(light, at.point, there.normal);
      for (int channel = 0; channel < channels_; ++channel)
        sums[static_cast<std::size_t>(channel)].add(level * light.share(channel));
    }
  }

  double levelFrom(const LightSource& light, Vec3 point, Vec3 normal) const {
    const Vec3 toLight = light.position - point;
    const double distance = length(toLight);
    const double level = light.levelAt(distance);
    // The middle of a ball can lie behind a plane that a part of it lights.
    return settings_.lambert ? level * std::max(0.0, dot(toLight, normal) / distance) : level;
  }

  const Level& level_;
  const std::vector<LightSight>& sights_;
  const BakeSettings& settings_;
  const LitSurfaces& surfaces_;
  const LitSurface& surface_;
  SurfaceId id_;
  SurfaceKind kind_;
  SamplePlacement placement_;
  std::vector<std::size_t> facing_;  ///< lights in front of the surface's plane
  int channels_ = 1;                 ///< 3 where one of them is coloured
  std::int64_t rays_ = 0;
};

/// Largest first, so that no thread starts the longest job last.
std::vector<std::size_t> byFallingSize(const LitSurfaces& surfaces) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i]) order.push_back(i);
  const auto texels = [&](std::size_t i) {
    return std::int64_t{surfaces[i]->texels.width} * surfaces[i]->texels.height;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return texels(a) > texels(b); });
  return order;
}

BakeStats statsOf(const BakedLight& baked, const std::vector<std::int64_t>& rays) {
  BakeStats stats;
  for (std::size_t i = 0; i < baked.surfaces.size(); ++i) {
    if (!baked.surfaces[i]) continue;
    const TexelRect& rect = baked.surfaces[i]->texels;
    ++stats.surfaces;
    stats.texels += std::int64_t{rect.width} * rect.height;
    stats.rays += rays[i];
    if (!baked.lightmaps[i]) continue;
    ++stats.litSurfaces;
    if (baked.lightmaps[i]->channels == 3) ++stats.coloredSurfaces;
    stats.bytes += static_cast<std::int64_t>(baked.lightmaps[i]->levels.size());
  }
  return stats;
}

}  // namespace

BakedLight bake(const Level& level, const BakeSettings& settings, int threads) {
  BakedLight baked;
  baked.surfaces = makeLitSurfaces(level, settings.texel);
  baked.lightmaps.resize(baked.surfaces.size());

  std::vector<LightSight> sights;
  for (const LightSource& light : level.lights)
    sights.emplace_back(level, light, settings.softSamples);

  std::vector<std::int64_t> rays(baked.surfaces.size(), 0);
  const std::vector<std::size_t> order = byFallingSize(baked.surfaces);
  parallelFor(order.size(), threads, [&](std::size_t job) {
    const std::size_t i = order[job];
    SurfaceBaker baker(level, baked.surfaces, sights, settings, SurfaceId(i));
    baked.lightmaps[i] = baker.bake();
    rays[i] = baker.rays();
  });
  baked.stats = statsOf(baked, rays);
  return baked;
}

}  // namespace hearth
