#include "light/bakery.h"

#include <algorithm>
#include <cmath>

#include "light/light_sum.h"
#include "light/parallel.h"
#include "light/raytracer.h"
#include "light/sample_placement.h"
#include "math/planted_bug.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Traces the light on single samples of one surface.
class SurfaceBaker {
 public:
  SurfaceBaker(const Level& level, const LitSurfaces& surfaces,
               const std::vector<Raytracer::Source>& sources, const BakeSettings& settings,
               SurfaceId id)
      : level_(level),
        sources_(sources),
        settings_(settings),
        surfaces_(surfaces),
        surface_(*surfaces[id.index()]),
        id_(id),
        kind_(level[id].kind),
        placement_(surfaces, id),
        raytracer_(level) {
    for (std::size_t i = 0; i < level.lights.size(); ++i)
      if (surface_.distanceInFront(level.lights[i].position) >
          (planted(PlantedBug::LightInPlaneShines) ? -kInPlane : kInPlane))
        facing_.push_back(i);
  }

  /// None where no light reaches the surface.
  std::optional<Lightmap> bake() {
    if (facing_.empty() || isPlantedUnlit()) return std::nullopt;
    const TexelRect rect = surface_.texels;
    Lightmap map{rect, {}};
    map.levels.reserve(static_cast<std::size_t>(rect.width) *
                       static_cast<std::size_t>(rect.height));
    bool lit = false;
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i) {
        map.levels.push_back(texelLevel(i, j));
        lit = lit || map.levels.back() != 0;
      }
    if (!lit) return std::nullopt;
    return map;
  }

  std::int64_t tests() const { return tests_; }

 private:
  bool isPlantedUnlit() const {
    return (planted(PlantedBug::SidewallsUnlit) && isSidewall(kind_)) ||
           (planted(PlantedBug::LowerStepsUnlit) && kind_ == SurfaceKind::LowerStep);
  }

  std::uint8_t texelLevel(int i, int j) {
    const int side = static_cast<int>(std::lround(std::sqrt(settings_.samples)));
    LightSum sum;
    for (int b = 0; b < side; ++b)
      for (int a = 0; a < side; ++a) addSample({i + (a + 0.5) / side, j + (b + 0.5) / side}, sum);
    return sum.mean(side * side);
  }

  void addSample(Vec2 texelPoint, LightSum& sum) {
    if (planted(PlantedBug::BorderTexelsBlack) && !surface_.contains(texelPoint)) return;
    const SamplePoint at = placement_.place(texelPoint);
    const LitSurface& there = *surfaces_[at.surface.index()];
    for (const std::size_t i : facing_) {
      const LightSource& light = level_.lights[i];
      // What continues a surface may lie a tolerance off its plane.
      if (there.distanceInFront(light.position) <= kInPlane && at.surface != id_) continue;
      ++tests_;
      if (raytracer_.sees(sources_[i], at.target, level_[at.surface].sector))
        sum.add(levelFrom(light, at.point, there.normal));
    }
  }

  double levelFrom(const LightSource& light, Vec3 point, Vec3 normal) const {
    const Vec3 toLight = light.position - point;
    const double distance = length(toLight);
    const double level = light.levelAt(distance);
    return settings_.lambert ? level * (dot(toLight, normal) / distance) : level;
  }

  const Level& level_;
  const std::vector<Raytracer::Source>& sources_;
  const BakeSettings& settings_;
  const LitSurfaces& surfaces_;
  const LitSurface& surface_;
  SurfaceId id_;
  SurfaceKind kind_;
  SamplePlacement placement_;
  Raytracer raytracer_;
  std::vector<std::size_t> facing_;  ///< lights in front of the surface's plane
  std::int64_t tests_ = 0;
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

BakeStats statsOf(const BakedLight& baked, const std::vector<std::int64_t>& tests) {
  BakeStats stats;
  for (std::size_t i = 0; i < baked.surfaces.size(); ++i) {
    if (!baked.surfaces[i]) continue;
    const TexelRect& rect = baked.surfaces[i]->texels;
    ++stats.surfaces;
    stats.texels += std::int64_t{rect.width} * rect.height;
    stats.tests += tests[i];
    if (!baked.lightmaps[i]) continue;
    ++stats.litSurfaces;
    stats.bytes += static_cast<std::int64_t>(baked.lightmaps[i]->levels.size());
  }
  return stats;
}

}  // namespace

BakedLight bake(const Level& level, const BakeSettings& settings, int threads) {
  BakedLight baked;
  baked.surfaces = makeLitSurfaces(level, settings.texel);
  baked.lightmaps.resize(baked.surfaces.size());

  std::vector<Raytracer::Source> sources;
  for (const LightSource& light : level.lights)
    sources.push_back(Raytracer::sourceOf(level, light));

  std::vector<std::int64_t> tests(baked.surfaces.size(), 0);
  const std::vector<std::size_t> order = byFallingSize(baked.surfaces);
  parallelFor(order.size(), threads, [&](std::size_t job) {
    const std::size_t i = order[job];
    SurfaceBaker baker(level, baked.surfaces, sources, settings, SurfaceId(i));
    baked.lightmaps[i] = baker.bake();
    tests[i] = baker.tests();
  });
  baked.stats = statsOf(baked, tests);
  return baked;
}

}  // namespace hearth
