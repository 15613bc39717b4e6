// What is seen from texels in all directions, against rays of Embree.

#include "truth/gather_rays.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "light/baking/bounces.h"
#include "light/gather/slice.h"
#include "math/tolerance.h"
#include "math/trig.h"
#include "measure/light_places.h"
#include "peers/embree.h"
#include "peers/evenly.h"
#include "peers/level_mesh.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

/// Of all texels of the level.
constexpr std::size_t kTexels = 4000;
/// Around each, evenly spread: as many as a bake begins with and halves once.
constexpr int kSlices = 16;
/// Degrees, so that none runs along an axis: walls do.
constexpr double kOffAxis = 0.0573;
/// Metres before its surface where a ray begins, so that it does not meet that.
constexpr double kBeforeSurface = 1e-4;

BakeSettings withBounces(BakeSettings settings) {
  settings.bounces = 1;
  return settings;
}

/// Some texels of a level, and what is seen from them.
class SeenFromTexels {
 public:
  SeenFromTexels(const Scene& scene, const BakedLight& light, EmbreeTracer tracer)
      : bounces_(scene, withBounces(scene.level().bake), 1),
        slice_(bounces_.scene(), scene.level().bake.solidMaskedMiddles),
        texels_(LightPlaces(scene, light).some(kTexels, [](const LightPlace&) { return true; })),
        tracer_(std::move(tracer)) {}

  Figures measure(const Clock& clock) {
    const double begin = clock();
    const std::vector<std::size_t> pairs = settle();
    const double own = clock() - begin;
    std::vector<HitPacket> packets = packetsFor(pairs);
    const double traceBegin = clock();
    tracer_.trace(packets);
    const double other = clock() - traceBegin;
    double all = 0;
    for (const std::size_t of : pairs) all += static_cast<double>(of);
    double rays = 0;
    double hits = 0;
    for (const HitPacket& packet : packets)
      for (std::size_t i = 0; i < std::size(packet.valid); ++i) {
        rays += packet.valid[i] != 0 ? 1 : 0;
        hits += packet.isHit(i) ? 1 : 0;
      }
    return {all / own / (rays / other),
            1e-6 * all / own,
            1e-6 * rays / other,
            1e-6 * all,
            all / static_cast<double>(kSlices * texels_.size()),
            100 * hits / rays};
  }

 private:
  /// For each texel: with how many ranges of slopes its slices meet a surface or a face.
  std::vector<std::size_t> settle() {
    std::vector<std::size_t> pairs;
    for (const LightPlace& texel : texels_) {
      const SurfacePoint& at = texel.point;
      std::size_t met = 0;
      for (int k = 0; k < kSlices; ++k) {
        const SinCos compass = sinCosDegrees(kOffAxis + 360.0 * k / kSlices);
        const Vec2 direction{compass.cos, compass.sin};
        const SlopeRange before = slopesBefore(at.normal, dot(at.normal.xy(), direction));
        const SliceStart start{at.point, at.sector, at.mesh ? kPositionSlack : kArrival};
        met += slice_.areas(start, direction, before, nullptr).size();
      }
      pairs.push_back(met);
    }
    return pairs;
  }

  /// As many rays from each texel, eight together: one compass direction after the other, so that
  /// those of a packet lie close together.
  std::vector<HitPacket> packetsFor(const std::vector<std::size_t>& pairs) const {
    std::vector<HitPacket> packets;
    for (std::size_t i = 0; i < texels_.size(); ++i) {
      const Vec3 normal = texels_[i].point.normal;
      const Vec3 origin = texels_[i].point.point + kBeforeSurface * normal;
      for (std::size_t k = 0; k < pairs[i]; ++k) {
        if (k % 8 == 0) packets.emplace_back();
        const double around = (static_cast<double>(k) + 0.5) / static_cast<double>(pairs[i]);
        const double u = evenly(static_cast<int>(i), static_cast<int>(k), 0);
        HitPacket& packet = packets.back();
        setRay(packet.rays.ray, k % 8, origin, cosineDirection(normal, u, around),
               std::numeric_limits<float>::infinity());
        packet.rays.hit.geomID[k % 8] = RTC_INVALID_GEOMETRY_ID;
        packet.valid[k % 8] = -1;
      }
    }
    return packets;
  }

  Bounces bounces_;
  Slice slice_;
  std::vector<LightPlace> texels_;
  EmbreeTracer tracer_;
};

}  // namespace

Prepared prepareGatherRays(PeerInputs& inputs) {
  const auto level = inputs.level(inputs.castleFile());
  if (!level) return tl::unexpected(level.error());
  const Scene scene = (*level)->loaded.scene();
  return EmbreeTracer::of(meshInLight(scene)).map([&](EmbreeTracer tracer) -> Measure {
    const auto rays = std::make_shared<SeenFromTexels>(scene, (*level)->light, std::move(tracer));
    return [rays, &inputs] { return rays->measure(inputs.clock()); };
  });
}

}  // namespace hearth
