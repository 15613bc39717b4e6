// Bakes against Embree, which traces a ray for each pair of a sample and a light.

#include <memory>

#include "light/baking/baked_surface.h"
#include "math/parallel.h"
#include "peers/bake_rays.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

/// Lamps as points, and one sample to a texel: a pair is a ray.
BakeSettings settingsOfPairs(const Level& level) {
  BakeSettings settings = level.bake;
  settings.samples = 1;
  settings.softSamples = 0;
  return settings;
}

double secondsOfBake(const Level& level, int threads, const Clock& clock) {
  const double begin = clock();
  (void)bake(level, settingsOfPairs(level), threads);
  return clock() - begin;
}

/// Seconds in which no sample is asked yet what it sees.
struct Groundwork {
  double placing;  ///< samples, and grouping them in blocks
  double beams;    ///< finding what lights see
};

Groundwork groundworkOf(const Level& level, int threads, const Clock& clock) {
  const BakeSettings settings = settingsOfPairs(level);
  const LitSurfaces surfaces = makeLitSurfaces(level, settings.texel);
  const LightSights sights(level, settings);
  const double begin = clock();
  parallelFor(surfaces.size(), threads, [&](std::size_t i) {
    if (!surfaces[i]) return;
    const SurfaceLight surface(level, surfaces, sights, settings.lambert, SurfaceId(i));
    if (surface.facing().empty()) return;
    for (const TexelRect& tile : tilesOf(surface.texels())) (void)samplesOf(surface, tile, 1);
  });
  const double placed = clock();
  parallelFor(sights.fine.size(), threads, [&](std::size_t i) { (void)sights.fine[i].beams(); });
  return {placed - begin, clock() - placed};
}

/// Embree with a level and the rays of its bake.
class EmbreePeer {
 public:
  static tl::expected<std::shared_ptr<const EmbreePeer>, std::string> of(const Level& level) {
    return EmbreeTracer::of(meshInLight(level)).map([&](EmbreeTracer tracer) {
      return std::make_shared<const EmbreePeer>(level, std::move(tracer));
    });
  }

  EmbreePeer(const Level& level, EmbreeTracer tracer)
      : level_(level),
        tracer_(std::move(tracer)),
        rays_(level, settingsOfPairs(level).texel, tracer_) {}

  const Level& level() const { return level_; }

  BakeRays::Traced traced(int threads, const Clock& clock) const {
    return rays_.traceAll(tracer_, threads, clock);
  }

 private:
  const Level& level_;
  EmbreeTracer tracer_;
  BakeRays rays_;
};

/// Pairs that a bake answers a second over rays that Embree does.
Prepared preparePairs(PeerInputs& inputs, const std::filesystem::path& file) {
  const auto scene = inputs.scene(file);
  if (!scene) return tl::unexpected(scene.error());
  return EmbreePeer::of((*scene)->loaded.level).map([&](const auto& peer) -> Measure {
    return [peer, &inputs] {
      const double ofBake = secondsOfBake(peer->level(), 1, inputs.clock());
      const BakeRays::Traced traced = peer->traced(1, inputs.clock());
      const auto [placing, beams] = groundworkOf(peer->level(), 1, inputs.clock());
      const double millions = 1e-6 * static_cast<double>(traced.rays);
      return Figures{traced.seconds / ofBake,
                     millions / ofBake,
                     millions / traced.seconds,
                     millions,
                     ofBake,
                     placing,
                     beams,
                     ofBake - placing - beams};
    };
  });
}

constexpr int kThreads = 2;

}  // namespace

Prepared prepareKeepPairs(PeerInputs& inputs) { return preparePairs(inputs, inputs.keepFile()); }
Prepared prepareTutorialPairs(PeerInputs& inputs) {
  return preparePairs(inputs, inputs.tutorialFile());
}

Prepared prepareLargestBake(PeerInputs& inputs) {
  return inputs.freedoomScene(kLargestMap).map([&](const Scene* scene) -> Measure {
    return [scene, &inputs] {
      return Figures{secondsOfBake(scene->loaded.level, kThreads, inputs.clock())};
    };
  });
}

Prepared prepareLargestRays(PeerInputs& inputs) {
  const auto scene = inputs.freedoomScene(kLargestMap);
  if (!scene) return tl::unexpected(scene.error());
  return EmbreePeer::of((*scene)->loaded.level).map([&](const auto& peer) -> Measure {
    return [peer, &inputs] {
      const double ofBake = secondsOfBake(peer->level(), kThreads, inputs.clock());
      const BakeRays::Traced traced = peer->traced(kThreads, inputs.clock());
      const auto [placing, beams] = groundworkOf(peer->level(), kThreads, inputs.clock());
      return Figures{ofBake / traced.seconds,
                     ofBake,
                     traced.seconds,
                     1e-6 * static_cast<double>(traced.rays),
                     placing,
                     beams,
                     ofBake - placing - beams};
    };
  });
}

}  // namespace hearth
