#pragma once

#include <cmath>
#include <cstdint>

#include "test_level.h"
#include "truth/truth_view.h"

namespace hearth {

/// What a camera of `cameraAt` sees at a point of the world before it.
class Look {
 public:
  Look(const TestLevel& test, const Shot& camera)
      : camera_(camera), view_(test.level(), test.textures(), camera) {}

  TruthPixel at(Vec3 point, TruthLightMode mode = TruthLightMode::None) const {
    const double radians = camera_.angle * std::acos(-1) / 180;
    const Vec2 forward{std::cos(radians), std::sin(radians)};
    const Vec3 toPoint = point - camera_.eye;
    const double perMetre = 4 / dot(forward, toPoint.xy());
    return view_.pixel(4 + perMetre * dot(turned90(forward), toPoint.xy()),
                       2 - perMetre * toPoint.z, mode);
  }
  SurfaceKind kindAt(Vec3 point) const { return at(point).hit.kind; }

 private:
  Shot camera_;
  TruthView view_;
};

/// Texel (x, y) of the texture, as TestLevel paints it.
inline Rgb texel(int x, int y, const TextureMapping& image) {
  return {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
          static_cast<std::uint8_t>(image.texture.index())};
}

}  // namespace hearth
