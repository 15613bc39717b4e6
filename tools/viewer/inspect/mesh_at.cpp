#include "viewer/inspect/mesh_at.h"

#include "truth/depth.h"
#include "truth/trace.h"

namespace hearth {

namespace {

/// The ray parameter at which a look meets a face, by the same edge functions as a FaceFront's.
std::optional<double> meet(const MeshFace& face, bool isTwoSided, Vec3 eye, Vec3 direction) {
  const Vec3 a = face.corners[0] - eye;
  const Vec3 b = face.corners[1] - eye;
  const Vec3 c = face.corners[2] - eye;
  const Vec3 out = frontOf(face);
  const double behind = dot(out, a);  // the eye is behind the face
  if (behind == 0 || (behind > 0 && !isTwoSided)) return std::nullopt;
  const double side = behind < 0 ? 1 : -1;
  for (const Vec3 edge : {cross(b, c), cross(c, a), cross(a, b)})
    if (side * dot(edge, direction) < 0) return std::nullopt;
  const double t = behind / dot(out, direction);
  return t > 0 ? std::optional(t) : std::nullopt;
}

/// Of two faces at one depth the later.
std::optional<MeshHit> nearestIn(const Level& level, const AirStretch& air, Vec3 eye,
                                 Vec3 direction) {
  std::optional<MeshHit> nearest;
  for (const MeshInSector& there : level.meshesIn(air.sector)) {
    const Mesh& mesh = level.meshes[there.mesh];
    for (std::uint32_t i = mesh.firstFace; i < mesh.firstFace + mesh.faceCount; ++i) {
      const auto t = meet(level.meshFaces[i], mesh.isTwoSided, eye, direction);
      if (t && isIn(air, *t) && (!nearest || hides(*t, nearest->t)))
        nearest = MeshHit{there.mesh, i, *t, eye + *t * direction};
    }
  }
  return nearest;
}

}  // namespace

std::optional<MeshHit> meshAt(const Level& level, SectorId sector, Vec3 eye, Vec3 direction) {
  std::optional<MeshHit> nearest;
  traceLook(level, sector, eye, direction, [&](const AirStretch& air) -> std::optional<TruthHit> {
    nearest = nearestIn(level, air, eye, direction);
    return nearest ? std::optional(TruthHit{}) : std::nullopt;
  });
  return nearest;
}

bool hides(const Level& level, const MeshHit& mesh, const SpriteHit& sprite) {
  const bool isLater = level.meshes[mesh.mesh].thing > level.sprites[sprite.sprite].thing;
  return isLater ? hides(mesh.t, sprite.t) : !hides(sprite.t, mesh.t);
}

}  // namespace hearth
