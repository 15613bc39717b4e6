#include "peers/embree.h"

#include <dlfcn.h>

namespace hearth {

namespace {

constexpr const char* kLibrary = "libembree3.so.3";

/// A function of a library that is loaded, of the type that the headers give it.
template <typename Function>
Function* functionOf(void* library, const char* name) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

/// Corners and indices into the buffers that Embree has made for them.
void fill(std::span<const MeshTriangle> mesh, float* vertices, unsigned* indices) {
  for (const MeshTriangle& triangle : mesh)
    for (const Vec3 corner : triangle.corners)
      for (const double coordinate : {corner.x, corner.y, corner.z})
        *vertices++ = static_cast<float>(coordinate);
  for (unsigned i = 0; i < 3 * mesh.size(); ++i) *indices++ = i;
}

}  // namespace

void setRay(RTCRay8& rays, std::size_t lane, Vec3 origin, Vec3 direction, float end) {
  rays.org_x[lane] = static_cast<float>(origin.x);
  rays.org_y[lane] = static_cast<float>(origin.y);
  rays.org_z[lane] = static_cast<float>(origin.z);
  rays.dir_x[lane] = static_cast<float>(direction.x);
  rays.dir_y[lane] = static_cast<float>(direction.y);
  rays.dir_z[lane] = static_cast<float>(direction.z);
  rays.tnear[lane] = 0;
  rays.tfar[lane] = end;
  rays.time[lane] = 0;
  rays.mask[lane] = ~0U;
  rays.flags[lane] = 0;
}

tl::expected<EmbreeTracer, std::string> EmbreeTracer::of(std::span<const MeshTriangle> mesh,
                                                         Edges edges) {
  EmbreeTracer tracer;
  // Never closed: threads of its own may still be in it.
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (!library)
    return tl::unexpected<std::string>("Embree is not here: apt-get install libembree3-3");
  const auto newBuffer =
      functionOf<decltype(rtcSetNewGeometryBuffer)>(library, "rtcSetNewGeometryBuffer");
  tracer.occluded8_ = functionOf<decltype(rtcOccluded8)>(library, "rtcOccluded8");
  tracer.occluded1_ = functionOf<decltype(rtcOccluded1)>(library, "rtcOccluded1");
  tracer.intersect8_ = functionOf<decltype(rtcIntersect8)>(library, "rtcIntersect8");
  tracer.device_ = {functionOf<decltype(rtcNewDevice)>(library, "rtcNewDevice")("threads=1"),
                    functionOf<decltype(rtcReleaseDevice)>(library, "rtcReleaseDevice")};
  RTCDevice device = tracer.device_.get();
  tracer.scene_ = {functionOf<decltype(rtcNewScene)>(library, "rtcNewScene")(device),
                   functionOf<decltype(rtcReleaseScene)>(library, "rtcReleaseScene")};
  RTCScene scene = tracer.scene_.get();

  RTCGeometry geometry = functionOf<decltype(rtcNewGeometry)>(library, "rtcNewGeometry")(
      device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(newBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * mesh.size()));
  auto* indices = static_cast<unsigned*>(newBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.size()));
  fill(mesh, vertices, indices);
  functionOf<decltype(rtcCommitGeometry)>(library, "rtcCommitGeometry")(geometry);
  functionOf<decltype(rtcAttachGeometry)>(library, "rtcAttachGeometry")(scene, geometry);
  functionOf<decltype(rtcReleaseGeometry)>(library, "rtcReleaseGeometry")(geometry);
  functionOf<decltype(rtcSetSceneBuildQuality)>(library, "rtcSetSceneBuildQuality")(
      scene, RTC_BUILD_QUALITY_HIGH);
  if (edges == Edges::Watertight)
    functionOf<decltype(rtcSetSceneFlags)>(library, "rtcSetSceneFlags")(scene,
                                                                        RTC_SCENE_FLAG_ROBUST);
  functionOf<decltype(rtcCommitScene)>(library, "rtcCommitScene")(scene);
  return tracer;
}

void EmbreeTracer::trace(std::span<RayPacket> packets) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (RayPacket& packet : packets) occluded8_(packet.valid, scene_.get(), &context, &packet.rays);
}

void EmbreeTracer::trace(std::span<HitPacket> packets) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (HitPacket& packet : packets) intersect8_(packet.valid, scene_.get(), &context, &packet.rays);
}

void EmbreeTracer::trace(std::span<RTCRay> rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (RTCRay& ray : rays) occluded1_(scene_.get(), &context, &ray);
}

}  // namespace hearth
