#pragma once

#include <cstdint>
#include <vector>

#include "level/scene.h"
#include "light/lit_mesh.h"
#include "light/lit_surface.h"
#include "measure/frame_times.h"
#include "peers/embree.h"

namespace hearth {

/// The rays of a bake with one sample to a texel and point lights, for another ray tracer: one
/// from each light to each sample that it lies before and is no farther from than it reaches, in
/// sectors into which any of it comes. Corners of the small faces of meshes are samples, too.
class BakeRays {
 public:
  /// `tracer` knows the scene, and is asked where light may come.
  BakeRays(const Scene& scene, double texel, const EmbreeTracer& tracer);

  struct Traced {
    std::int64_t rays = 0;
    std::int64_t free = 0;  ///< of those, that met nothing on their way
    double seconds = 0;     ///< that tracing alone took, with all threads as long at work
  };
  Traced traceAll(const EmbreeTracer& tracer, int threads, const Clock& clock) const;

 private:
  struct Sample {
    Vec3 target;  ///< where rays arrive
    SectorId sector;
  };
  struct SurfaceSamples {
    std::vector<std::vector<Sample>> rows;
    std::vector<std::size_t> lights;  ///< that it faces
  };

  SurfaceSamples samplesOf(const LitSurfaces& surfaces, SurfaceId id) const;
  void addMesh(const Mesh& mesh, const LitMesh& lit);
  void findReached(const EmbreeTracer& tracer);
  /// Calls use(light, row, first, packet) for each packet of rays to every so many rows of a
  /// surface: to the samples of a row from the first on.
  template <typename Use>
  void forEachPacket(const SurfaceSamples& surface, std::size_t everyRow, Use&& use) const;
  bool takes(std::size_t light, const Sample& sample) const;
  std::size_t indexOf(std::size_t light, SectorId sector) const {
    return light * scene_.level().sectors.size() + sector.index();
  }

  Scene scene_;
  std::vector<SurfaceSamples> surfaces_;
  std::vector<double> reach_;  ///< by light, metres
  std::vector<bool> reached_;  ///< by light and sector: whether any of it comes there
};

}  // namespace hearth
