// Bakes against Embree, which traces a ray for each pair of a sample and a light; and in parts.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "light/bake_part.h"
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

double secondsOfBake(const Scene& scene, int threads, const Clock& clock) {
  const double begin = clock();
  (void)bake(scene, settingsOfPairs(scene.level()), threads);
  return clock() - begin;
}

/// Seconds in which no sample is asked yet what it sees.
struct Groundwork {
  double placing;  ///< samples, and grouping them in blocks
  double beams;    ///< finding what lights see
};

Groundwork groundworkOf(const Scene& scene, int threads, const Clock& clock) {
  const BakeSettings settings = settingsOfPairs(scene.level());
  const LitSurfaces surfaces = makeLitSurfaces(scene, settings.texel);
  const LightVisibilities visibilities(scene, settings);
  const double begin = clock();
  parallelFor(surfaces.size(), threads, [&](std::size_t i) {
    if (!surfaces[i]) return;
    const SurfaceLight surface(scene, surfaces, visibilities, settings.lambert, SurfaceId(i));
    if (surface.facing().empty()) return;
    const UsedTexels texels(*surfaces[i], surfaces[i]->texels);
    for (const TexelRect& tile : tilesOf(texels)) (void)samplesOf(surface, texels, tile, 1);
  });
  const double placed = clock();
  parallelFor(visibilities.reach.lights(), threads,
              [&](std::size_t i) { (void)visibilities.fine(i).beams(); });
  return {placed - begin, clock() - placed};
}

/// Embree with a level and the rays of its bake.
class EmbreePeer {
 public:
  static tl::expected<std::shared_ptr<const EmbreePeer>, std::string> of(const Scene& scene) {
    return EmbreeTracer::of(meshInLight(scene)).map([&](EmbreeTracer tracer) {
      return std::make_shared<const EmbreePeer>(scene, std::move(tracer));
    });
  }

  EmbreePeer(const Scene& scene, EmbreeTracer tracer)
      : scene_(scene),
        tracer_(std::move(tracer)),
        rays_(scene, settingsOfPairs(scene.level()).texel, tracer_) {}

  const Scene& scene() const { return scene_; }

  BakeRays::Traced traced(int threads, const Clock& clock) const {
    return rays_.traceAll(tracer_, threads, clock);
  }

 private:
  Scene scene_;
  EmbreeTracer tracer_;
  BakeRays rays_;
};

/// Pairs that a bake answers a second over rays that Embree does.
Prepared preparePairs(PeerInputs& inputs, const std::filesystem::path& file) {
  const auto level = inputs.level(file);
  if (!level) return tl::unexpected(level.error());
  return EmbreePeer::of((*level)->loaded.scene()).map([&](const auto& peer) -> Measure {
    return [peer, &inputs] {
      const double ofBake = secondsOfBake(peer->scene(), 1, inputs.clock());
      const BakeRays::Traced traced = peer->traced(1, inputs.clock());
      const auto [placing, beams] = groundworkOf(peer->scene(), 1, inputs.clock());
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

/// What 16 parts of a bake take, one after the other on one thread.
struct PartTimes {
  double together = 0;  ///< seconds
  double slowest = 0;
  std::size_t bytes = 0;

  static constexpr std::uint32_t kParts = 16;
  double mean() const { return together / kParts; }
};

PartTimes timesOfParts(const BakeInParts& bake, const Clock& clock) {
  PartTimes times;
  for (std::uint32_t part = 1; part <= PartTimes::kParts; ++part) {
    const double begin = clock();
    times.bytes += bakePart(bake, {part, PartTimes::kParts}, 1).size();
    const double seconds = clock() - begin;
    times.together += seconds;
    times.slowest = std::max(times.slowest, seconds);
  }
  return times;
}

BakeInParts inParts(const Scene& scene) { return {scene, settingsOfPairs(scene.level()), ""}; }

}  // namespace

Prepared prepareCastlePairs(PeerInputs& inputs) {
  return preparePairs(inputs, inputs.castleFile());
}
Prepared prepareTutorialPairs(PeerInputs& inputs) {
  return preparePairs(inputs, inputs.tutorialFile());
}

Prepared prepareLargestBake(PeerInputs& inputs) {
  return inputs.freedoomLevel(kLargestMap).map([&](const PeerLevel* level) -> Measure {
    return [level, &inputs] {
      return Figures{secondsOfBake(level->loaded.scene(), kThreads, inputs.clock())};
    };
  });
}

Prepared prepareLargestRays(PeerInputs& inputs) {
  const auto level = inputs.freedoomLevel(kLargestMap);
  if (!level) return tl::unexpected(level.error());
  return EmbreePeer::of((*level)->loaded.scene()).map([&](const auto& peer) -> Measure {
    return [peer, &inputs] {
      const double ofBake = secondsOfBake(peer->scene(), kThreads, inputs.clock());
      const BakeRays::Traced traced = peer->traced(kThreads, inputs.clock());
      const auto [placing, beams] = groundworkOf(peer->scene(), kThreads, inputs.clock());
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

Prepared prepareSlowestPart(PeerInputs& inputs) {
  return inputs.freedoomLevel(kLargestMap).map([&](const PeerLevel* level) -> Measure {
    return [level, &inputs] {
      const PartTimes times = timesOfParts(inParts(level->loaded.scene()), inputs.clock());
      return Figures{times.slowest / times.mean(), times.slowest, times.mean()};
    };
  });
}

Prepared preparePartsTogether(PeerInputs& inputs) {
  return inputs.freedoomLevel(kLargestMap).map([&](const PeerLevel* level) -> Measure {
    return [level, &inputs] {
      const Scene scene = level->loaded.scene();
      const PartTimes times = timesOfParts(inParts(scene), inputs.clock());
      const double whole = secondsOfBake(scene, 1, inputs.clock());
      return Figures{times.together / whole, times.together, whole,
                     1e-6 * static_cast<double>(times.bytes)};
    };
  });
}

}  // namespace hearth
