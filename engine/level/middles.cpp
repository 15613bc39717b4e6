#include "level/middles.h"

#include <cmath>

namespace hearth {

namespace {

/// The texel of an image that repeats, `size` texels long.
int repeated(double texel, int size) {
  const double rest = std::fmod(std::floor(texel), size);
  return static_cast<int>(rest < 0 ? rest + size : rest);
}

}  // namespace

bool isSolidAt(const Level& level, const Surface& middle, Vec3 point) {
  const TextureMapping& mapping = middle.mapping;
  if (mapping.texture.index() >= level.holes.size()) return true;
  const TexelHoles& holes = level.holes[mapping.texture.index()];
  if (holes.all().empty()) return true;
  const Segment& segment = level[*middle.segment];
  const double s = mapping.along + segment.sBefore + length(point.xy() - segment.p0);
  const double u = holes.width() * s / mapping.repeat.x - mapping.offsetTexels.x;
  const double v =
      holes.height() * (*mapping.zRef - point.z) / mapping.repeat.y - mapping.offsetTexels.y;
  return !holes.at(repeated(u, holes.width()), repeated(v, holes.height()));
}

}  // namespace hearth
