#pragma once

#include <embree3/rtcore.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "peers/level_mesh.h"

namespace hearth {

/// Sets one of eight rays, in single precision, of parameters from 0 to an end.
void setRay(RTCRay8& rays, std::size_t lane, Vec3 origin, Vec3 direction, float end);

/// Eight rays that are traced together, in single precision. `valid` is -1 of those that count.
struct RayPacket {
  RTCRay8 rays;
  alignas(32) int valid[8];

  /// Once it is traced: whether such a ray met nothing.
  bool isFree(std::size_t i) const { return valid[i] != 0 && rays.tfar[i] >= 0; }
};

/// Eight rays of which each ends at what it first meets, in single precision.
struct HitPacket {
  RTCRayHit8 rays;
  alignas(32) int valid[8];  ///< -1 of those that count

  /// Once it is traced: whether such a ray has met anything.
  bool isHit(std::size_t i) const {
    return valid[i] != 0 && rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
  }
};

/// Whether rays may slip between triangles that share an edge.
enum class Edges { Fast, Watertight };

/// Triangles in Embree, which is loaded when the program runs: it need not be installed.
class EmbreeTracer {
 public:
  /// The error says that Embree is missing, and what brings it.
  static tl::expected<EmbreeTracer, std::string> of(std::span<const MeshTriangle> mesh,
                                                    Edges edges = Edges::Fast);

  /// Finds which of the rays meet anything, on this thread alone.
  void trace(std::span<RayPacket> packets) const;
  /// Finds what each of the rays first meets, on this thread alone.
  void trace(std::span<HitPacket> packets) const;
  /// Which meet anything, of rays that are traced one by one: Embree makes `tfar` of such negative.
  void trace(std::span<RTCRay> rays) const;

 private:
  EmbreeTracer() = default;

  // Destroyed in reverse order: the device last.
  std::shared_ptr<RTCDeviceTy> device_;
  std::shared_ptr<RTCSceneTy> scene_;
  decltype(&rtcOccluded8) occluded8_ = nullptr;
  decltype(&rtcOccluded1) occluded1_ = nullptr;
  decltype(&rtcIntersect8) intersect8_ = nullptr;
};

}  // namespace hearth
