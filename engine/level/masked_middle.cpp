#include "level/masked_middle.h"

#include "math/wrapped.h"

namespace hearth {

bool isSolidAt(const Scene& scene, SurfaceId maskedMiddle, Vec3 point) {
  const TextureMapping& mapping = scene[maskedMiddle].mapping;
  const std::vector<TexelHoles>& ofTextures = scene.level().holes;
  if (mapping.texture.index() >= ofTextures.size()) return true;
  const TexelHoles& holes = ofTextures[mapping.texture.index()];
  if (holes.bits().empty()) return true;
  const Segment& segment = scene[*scene[maskedMiddle].segment];
  const double s = mapping.along + segment.sBefore + length(point.xy() - segment.p0);
  const double u = holes.width() * s / mapping.repeat.x - mapping.offsetTexels.x;
  const double zRef = *scene.geometryOf(maskedMiddle).zRef;
  const double v = holes.height() * (zRef - point.z) / mapping.repeat.y - mapping.offsetTexels.y;
  return !holes.isHole(wrapped(u, holes.width()), wrapped(v, holes.height()));
}

}  // namespace hearth
