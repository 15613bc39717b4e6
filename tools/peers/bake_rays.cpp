#include "peers/bake_rays.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <tuple>

#include "light/rays/raytracer.h"
#include "light/sampling/sample_placement.h"
#include "light/used_texels.h"
#include "math/parallel.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr std::size_t kLanes = 8;
/// Packets that are traced at once: what is timed takes much longer than to read a clock, and the
/// second cache still holds them (196 KB).
constexpr std::size_t kPackets = 512;
/// Of the lightmaps' rows, those that are asked which light comes where.
constexpr std::size_t kRowsApart = 8;
/// Of the way from the light to the surface: what lies on the surface itself is not met.
constexpr float kWay = 0.9999F;

/// Of the small faces before which a point lies, the corners, each once.
std::vector<Vec3> cornersSeenFrom(Vec3 point, std::span<const MeshFace> faces,
                                  std::span<const LitMesh::SmallFace> small) {
  std::vector<Vec3> corners;
  for (const LitMesh::SmallFace& each : small) {
    const MeshFace& face = faces[each.face];
    if (dot(frontOf(face), point - face.corners[0]) > 0)
      corners.insert(corners.end(), face.corners.begin(), face.corners.end());
  }
  const auto coordinates = [](Vec3 p) { return std::tuple(p.x, p.y, p.z); };
  std::ranges::sort(corners, {}, coordinates);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<std::size_t> lightsBefore(const Level& level, const LitSurface& surface) {
  std::vector<std::size_t> lights;
  for (std::size_t i = 0; i < level.lights.size(); ++i)
    if (surface.distanceInFront(level.lights[i].position) > kInPlane) lights.push_back(i);
  return lights;
}

std::int64_t raysIn(const RayPacket& packet) {
  return std::int64_t{kLanes} - std::ranges::count(packet.valid, 0);
}

}  // namespace

BakeRays::BakeRays(const Scene& scene, double texel, const EmbreeTracer& tracer)
    : scene_(scene), reached_(scene.level().lights.size() * scene.level().sectors.size(), true) {
  for (const LightSource& light : scene.level().lights) reach_.push_back(light.reach(0));
  const LitSurfaces surfaces = makeLitSurfaces(scene, texel);
  surfaces_.resize(surfaces.size());
  parallelFor(surfaces.size(), availableThreads(), [&](std::size_t i) {
    if (surfaces[i]) surfaces_[i] = samplesOf(surfaces, SurfaceId(i));
  });
  const std::vector<LitMesh> meshes = makeLitMeshes(scene.level(), texel, availableThreads());
  for (std::size_t i = 0; i < meshes.size(); ++i) addMesh(scene.level().meshes[i], meshes[i]);
  findReached(tracer);
}

BakeRays::SurfaceSamples BakeRays::samplesOf(const LitSurfaces& surfaces, SurfaceId id) const {
  const LitSurface& surface = *surfaces[id.index()];
  const SamplePlacement placement(surfaces, id);
  SurfaceSamples samples;
  samples.lights = lightsBefore(scene_.level(), surface);
  if (samples.lights.empty()) return samples;
  const TexelRect& rect = surface.texels;
  const UsedTexels texels(surface, rect);
  for (int j = rect.j0; j < rect.j0 + rect.height; ++j) {
    std::vector<Sample>& row = samples.rows.emplace_back();
    texels.forEachRunIn(rect, j, [&](int first, int last) {
      for (int i = first; i <= last; ++i) {
        const SamplePoint at = placement.place({i + 0.5, j + 0.5});
        row.push_back({at.target, scene_[at.surface].sector});
      }
    });
  }
  return samples;
}

void BakeRays::addMesh(const Mesh& mesh, const LitMesh& lit) {
  for (const LitMesh::Patch& patch : lit.patches) {
    SurfaceSamples& samples = surfaces_.emplace_back(samplesOf({patch.surface}, SurfaceId(0)));
    for (std::vector<Sample>& row : samples.rows)
      for (Sample& sample : row) sample.sector = mesh.sector;
  }
  for (std::size_t i = 0; i < scene_.level().lights.size(); ++i) {
    SurfaceSamples& samples = surfaces_.emplace_back();
    samples.lights = {i};
    std::vector<Sample>& row = samples.rows.emplace_back();
    for (const Vec3 corner : cornersSeenFrom(scene_.level().lights[i].position,
                                             scene_.level().facesOf(mesh), lit.smallFaces))
      row.push_back({corner, mesh.sector});
  }
}

/// At first all sectors count. Rays that `tracer` lets pass are asked for again in the level
/// itself: over walls beneath a sky, for one, there is nothing else to stop them.
void BakeRays::findReached(const EmbreeTracer& tracer) {
  const Raytracer raytracer(scene_);
  std::vector<std::atomic<bool>> found(reached_.size());
  parallelFor(surfaces_.size(), availableThreads(), [&](std::size_t i) {
    forEachPacket(surfaces_[i], kRowsApart,
                  [&](std::size_t light, const std::vector<Sample>& row, std::size_t first,
                      RayPacket& packet) {
                    tracer.trace({&packet, 1});
                    const auto source = Raytracer::sourceOf(scene_, scene_.level().lights[light]);
                    for (std::size_t lane = 0; lane < kLanes; ++lane) {
                      if (!packet.isFree(lane)) continue;
                      const Sample& sample = row[first + lane];
                      std::atomic<bool>& isFound = found[indexOf(light, sample.sector)];
                      if (!isFound && raytracer.sees(source, sample.target, sample.sector))
                        isFound = true;
                    }
                  });
  });
  std::copy(found.begin(), found.end(), reached_.begin());
}

template <typename Use>
void BakeRays::forEachPacket(const SurfaceSamples& surface, std::size_t everyRow, Use&& use) const {
  RayPacket packet{};
  for (const std::size_t light : surface.lights)
    for (std::size_t j = 0; j < surface.rows.size(); j += everyRow) {
      const std::vector<Sample>& row = surface.rows[j];
      for (std::size_t first = 0; first < row.size(); first += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          const bool isThere = first + lane < row.size() && takes(light, row[first + lane]);
          packet.valid[lane] = isThere ? -1 : 0;
          const Sample& sample = row[std::min(first + lane, row.size() - 1)];
          const Vec3 from = scene_.level().lights[light].position;
          setRay(packet.rays, lane, from, sample.target - from, kWay);
        }
        if (raysIn(packet) > 0) use(light, row, first, packet);
      }
    }
}

bool BakeRays::takes(std::size_t light, const Sample& sample) const {
  const Vec3 toLight = scene_.level().lights[light].position - sample.target;
  return reached_[indexOf(light, sample.sector)] && length(toLight) < reach_[light];
}

BakeRays::Traced BakeRays::traceAll(const EmbreeTracer& tracer, int threads,
                                    const Clock& clock) const {
  std::vector<Traced> bySurface(surfaces_.size());
  parallelFor(surfaces_.size(), threads, [&](std::size_t i) {
    Traced& traced = bySurface[i];
    std::vector<RayPacket> packets;
    const auto traceThem = [&] {
      const double begin = clock();
      tracer.trace(packets);
      traced.seconds += clock() - begin;
      for (const RayPacket& packet : packets)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          traced.free += packet.isFree(lane) ? 1 : 0;
      packets.clear();
    };
    forEachPacket(
        surfaces_[i], 1,
        [&](std::size_t, const std::vector<Sample>&, std::size_t, const RayPacket& packet) {
          traced.rays += raysIn(packet);
          packets.push_back(packet);
          if (packets.size() == kPackets) traceThem();
        });
    traceThem();
  });
  Traced sum;
  for (const Traced& traced : bySurface) {
    sum.rays += traced.rays;
    sum.free += traced.free;
    sum.seconds += traced.seconds / threads;
  }
  return sum;
}

}  // namespace hearth
