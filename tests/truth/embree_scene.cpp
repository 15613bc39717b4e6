#include "embree_scene.h"

#include <limits>

namespace hearth {

namespace {

/// Embree takes triangles for two-sided: turns down hits from behind.
void turnDownBacks(const RTCFilterFunctionNArguments* arguments) {
  const auto& mesh = *static_cast<const std::vector<MeshTriangle>*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
    const Vec3 direction{RTCRayN_dir_x(arguments->ray, arguments->N, i),
                         RTCRayN_dir_y(arguments->ray, arguments->N, i),
                         RTCRayN_dir_z(arguments->ray, arguments->N, i)};
    if (dot(mesh[triangle].normal, direction) >= 0) arguments->valid[i] = 0;
  }
}

}  // namespace

EmbreeScene::EmbreeScene(std::vector<MeshTriangle>& mesh)
    : mesh_(mesh), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * mesh.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.size()));
  for (const MeshTriangle& triangle : mesh)
    for (const Vec3 corner : triangle.corners)
      for (const double coordinate : {corner.x, corner.y, corner.z})
        *vertices++ = static_cast<float>(coordinate);
  for (unsigned i = 0; i < 3 * mesh.size(); ++i) *indices++ = i;
  rtcSetGeometryUserData(geometry, &mesh);
  rtcSetGeometryIntersectFilterFunction(geometry, turnDownBacks);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

const MeshTriangle* EmbreeScene::firstMet(const FloatRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray.org_x = ray.origin[0];
  query.ray.org_y = ray.origin[1];
  query.ray.org_z = ray.origin[2];
  query.ray.dir_x = ray.direction[0];
  query.ray.dir_y = ray.direction[1];
  query.ray.dir_z = ray.direction[2];
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.primID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &query);
  return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? nullptr : &mesh_[query.hit.primID];
}

}  // namespace hearth
