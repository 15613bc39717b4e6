#include "light/gather/irradiance.h"

#include <algorithm>
#include <limits>

namespace hearth {

Irradiance::Irradiance(const Level& level, double reflectance)
    : level_(level),
      maps_(level.surfaces.size()),
      patchOf_(level.meshFaces.size(), std::numeric_limits<std::uint32_t>::max()),
      evenFaces_(level.meshFaces.size()) {
  for (const Vec3 of : level.reflectances)
    reflectances_.push_back({std::min(reflectance * of.x, kMostReflected),
                             std::min(reflectance * of.y, kMostReflected),
                             std::min(reflectance * of.z, kMostReflected)});
}

void Irradiance::setPatch(std::span<const std::uint32_t> faces, IrradianceMap map) {
  for (const std::uint32_t face : faces)
    patchOf_[face] = static_cast<std::uint32_t>(patches_.size());
  patches_.push_back(std::move(map));
}

}  // namespace hearth
