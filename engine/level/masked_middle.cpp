#include "level/masked_middle.h"

#include "math/wrapped.h"

namespace hearth {

bool isSolidAt(const Level& level, const Surface& maskedMiddle, Vec3 point) {
  const TextureMapping& mapping = maskedMiddle.mapping;
  if (mapping.texture.index() >= level.holes.size()) return true;
  const TexelHoles& holes = level.holes[mapping.texture.index()];
  if (holes.all().empty()) return true;
  const Segment& segment = level[*maskedMiddle.segment];
  const double s = mapping.along + segment.sBefore + length(point.xy() - segment.p0);
  const double u = holes.width() * s / mapping.repeat.x - mapping.offsetTexels.x;
  const double v =
      holes.height() * (*mapping.zRef - point.z) / mapping.repeat.y - mapping.offsetTexels.y;
  return !holes.at(wrapped(u, holes.width()), wrapped(v, holes.height()));
}

}  // namespace hearth
