// Rays from lights past a model of many triangles, against Embree.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "level/face_ray.h"
#include "level/face_tree.h"
#include "math/check.h"
#include "peers/embree.h"
#include "peers/level_mesh.h"
#include "peers/model_scene.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

/// Metres between rays' ends on floor and walls, as between texels of a bake.
constexpr double kApart = 1.0 / 8;
/// Of the model's faces, those in whose middles a ray ends.
constexpr std::size_t kFacesApart = 3;
/// Of the way from a light: what lies on the surface itself is not met.
constexpr double kToSurface = 0.9999;
/// Of the rays, that the two may answer differently: Embree computes in single precision.
constexpr double kRaysMayDiffer = 1e-4;
/// In the hole of the torus, above that, beside the torus, and under the ceiling.
constexpr std::array<Vec3, 4> kLights{{{0, 0, 2}, {0.3, -0.2, 3.4}, {-2.5, 1, 2.2}, {4, 3, 6.5}}};

/// Points of a parallelogram, row by row.
void addGrid(Vec3 from, Vec3 right, Vec3 up, std::vector<Vec3>& points) {
  const auto count = [](Vec3 side) { return static_cast<int>(length(side) / kApart); };
  const int columns = count(right);
  const int rows = count(up);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      points.push_back(from + (i + 0.5) / columns * right + (j + 0.5) / rows * up);
}

/// Of the floor and the walls around a sector whose first loop is its border, and of a model in it.
std::vector<Vec3> endsOfRays(const Scene& scene, std::span<const MeshFace> model) {
  std::vector<Vec3> ends;
  const Sector& room = scene.level().sectors.front();
  const auto [floor, ceiling] = scene.geometryOf(room);
  const Vec2 size = room.box.max - room.box.min;
  addGrid({room.box.min.x, room.box.min.y, floor}, {size.x, 0, 0}, {0, size.y, 0}, ends);
  for (const Segment& wall : scene.segmentsOf(room)) {
    const Vec2 along = wall.p1 - wall.p0;
    addGrid({wall.p0.x, wall.p0.y, floor}, {along.x, along.y, 0}, {0, 0, ceiling - floor}, ends);
  }
  for (std::size_t i = 0; i < model.size(); i += kFacesApart) {
    const auto& [a, b, c] = model[i].corners;
    ends.push_back((1.0 / 3) * (a + b + c));
  }
  return ends;
}

struct LightRay {
  Vec3 origin;
  Vec3 direction;  ///< to its end
};

RTCRay embreeRay(const LightRay& ray) {
  const auto single = [](double x) { return static_cast<float>(x); };
  return {.org_x = single(ray.origin.x),
          .org_y = single(ray.origin.y),
          .org_z = single(ray.origin.z),
          .tnear = 0,
          .dir_x = single(ray.direction.x),
          .dir_y = single(ray.direction.y),
          .dir_z = single(ray.direction.z),
          .time = 0,
          .tfar = single(kToSurface),
          .mask = ~0U,
          .id = 0,
          .flags = 0};
}

/// Rays past the one model of a level, each traced by Hearth and by Embree.
class ShadowRays {
 public:
  ShadowRays(const Scene& scene, EmbreeTracer tracer)
      : tracer_(std::move(tracer)),
        tree_(scene.level().faceTrees.front()),
        model_(scene.level().facesOf(scene.level().meshes.front())) {
    const std::vector<Vec3> ends = endsOfRays(scene, model_);
    for (const Vec3 light : kLights)
      for (const Vec3 end : ends) rays_.push_back({light, end - light});
    stopped_.resize(rays_.size());
  }

  /// The part of the rays of which one stops and the other passes.
  double differing() {
    trace();
    std::vector<RTCRay> peers = embreeRays();
    tracer_.trace(peers);
    double differing = 0;
    for (std::size_t i = 0; i < peers.size(); ++i)
      differing += (stopped_[i] != 0) == (peers[i].tfar < 0) ? 0 : 1;
    return differing / count();
  }

  Figures measure(const Clock& clock) {
    std::vector<RTCRay> peers = embreeRays();
    const double begin = clock();
    trace();
    const double traced = clock();
    tracer_.trace(peers);
    const double own = traced - begin;
    const double other = clock() - traced;
    const double ofFaces = secondsOfFaces(clock);
    const double stopped = static_cast<double>(std::ranges::count(stopped_, 1));
    const double bytes = static_cast<double>(tree_.bytes());
    return {other / own,
            1e-6 * count() / own,
            1e-6 * count() / other,
            1e-6 * count(),
            100 * stopped / count(),
            bytes / static_cast<double>(model_.size()),
            1e9 * (own - ofFaces) / count(),
            1e9 * ofFaces / count()};
  }

 private:
  double count() const { return static_cast<double>(rays_.size()); }

  std::vector<RTCRay> embreeRays() const {
    std::vector<RTCRay> peers;
    for (const LightRay& ray : rays_) peers.push_back(embreeRay(ray));
    return peers;
  }

  void trace() {
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const FaceRay ray(rays_[i].origin, rays_[i].direction);
      stopped_[i] = tree_.stops(model_, ray, 0, kToSurface) ? 1 : 0;
    }
  }

  /// That testing takes of the faces that the boxes leave, without these.
  double secondsOfFaces(const Clock& clock) const {
    std::vector<std::uint32_t> tested;
    std::vector<std::size_t> ends;
    for (const LightRay& each : rays_) {
      const FaceRay ray(each.origin, each.direction);
      (void)tree_.anyFaceOn(tree_.boxRay(ray, 0, kToSurface), [&](std::uint32_t face) {
        tested.push_back(face);
        return isMet(ray, face);
      });
      ends.push_back(tested.size());
    }
    const double begin = clock();
    std::size_t next = 0;
    std::size_t met = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const FaceRay ray(rays_[i].origin, rays_[i].direction);
      for (; next < ends[i]; ++next) met += isMet(ray, tested[next]) ? 1 : 0;
    }
    CHECK(met == static_cast<std::size_t>(std::ranges::count(stopped_, 1)), met);
    return clock() - begin;
  }

  bool isMet(const FaceRay& ray, std::uint32_t face) const {
    const std::optional<FaceRay::Crossing> crossing = ray.crossingOf(model_[face]);
    return crossing && crossing->t > 0 && crossing->t <= kToSurface;
  }

  EmbreeTracer tracer_;
  const FaceTree& tree_;
  std::span<const MeshFace> model_;
  std::vector<LightRay> rays_;
  std::vector<std::uint8_t> stopped_;  ///< by ray: whether it meets the model
};

}  // namespace

Prepared prepareShadowRays(PeerInputs& inputs) {
  const auto made = makeModelScene(inputs);
  if (!made) return tl::unexpected(made.error());
  const Scene scene = made->level->loaded.scene();
  auto tracer =
      EmbreeTracer::of(trianglesOf(scene, scene.level().meshes.front()), Edges::Watertight);
  if (!tracer) return tl::unexpected(tracer.error());
  const auto rays = std::make_shared<ShadowRays>(scene, *std::move(tracer));
  if (const double differing = rays->differing(); differing > kRaysMayDiffer)
    return tl::unexpected(fmt::format("the two differ in {:.3f} % of the rays", 100 * differing));
  return [rays, &inputs] { return rays->measure(inputs.clock()); };
}

}  // namespace hearth
