#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "light/lit_surface.h"
#include "math/vec.h"

namespace hearth {

/// Directions of one compass direction, from one to a higher one: unit vectors, metres along the
/// map and up.
struct Arc {
  Vec2 from;
  Vec2 to;
  double angle;  ///< between them, radians
};

/// The light on a surface, as coarse as one wants it: a mip pyramid (L. Williams, "Pyramidal
/// Parametrics", 1983) of levels of red, green and blue.
class IrradianceMap {
 public:
  /// Keeps where the surface lies. Texels without weight do not count.
  IrradianceMap(const LitSurface& surface, const TexelRect& rect);

  /// Sets a texel of `rect`.
  void set(int i, int j, Vec3 levels);
  /// Has it not count.
  void leaveOut(int i, int j);
  /// Once all are set.
  void finish();

  bool isDark() const { return isDark_; }

  /// Calls `visit(arc, levels)` for parts of an arc from a point before the surface, all of which
  /// meets it first: parts so short that the light is nearly the same all over one. `across` is how
  /// wide a part is beside its compass direction, radians.
  template <typename Visit>
  void forEachPart(Vec3 from, Vec2 direction, const Arc& arc, double across, Visit&& visit) const;

 private:
  /// Of 2^k x 2^k texels each.
  struct Mip {
    int width;
    int height;
    std::vector<float> cells;  ///< red, green, blue, weight; levels times weight
  };

  float* finestAt(int i, int j);
  Vec3 levelsAt(Vec2 texels, double width) const;

  TexelGrid grid_;
  Vec3 anchor_;
  Vec3 normal_;
  TexelRect rect_;
  std::vector<Mip> mips_;  ///< from fine to coarse
  bool isDark_ = true;
};

// --- Inline --------------------------------------------------------------------------------------

template <typename Visit>
void IrradianceMap::forEachPart(Vec3 from, Vec2 direction, const Arc& arc, double across,
                                Visit&& visit) const {
  // Parts are halved until they are no wider than this, and do not lead twice as far at one end ...
  constexpr double kWidest = 0.2;
  // ... unless they are narrower than that.
  constexpr double kNarrowest = 0.02;
  const double toPlane = dot(normal_, anchor_ - from);
  const double ahead = dot(normal_.xy(), direction);
  // Metres to the plane. Rounding may put ends of arcs beyond its horizon.
  const auto distanceTo = [&](Vec2 to) {
    constexpr double kFarthest = 1e9;
    const double towards = ahead * to.x + normal_.z * to.y;
    const double distance = toPlane / towards;
    return distance > 0 && distance < kFarthest ? distance : kFarthest;
  };
  const auto halve = [&](const auto& self, const Arc& part, double first, double last) -> void {
    const Vec2 sum = part.from + part.to;
    const double size = length(sum);
    // Ends of a half circle have a sum of nothing: its middle is ahead.
    const Vec2 middle = size > 1e-6 ? (1 / size) * sum : Vec2{1, 0};
    const double distance = distanceTo(middle);
    const bool isUneven = std::max(first, last) > 2 * std::min(first, last);
    if (part.angle > kWidest || (isUneven && part.angle > kNarrowest)) {
      self(self, {part.from, middle, part.angle / 2}, first, distance);
      self(self, {middle, part.to, part.angle / 2}, distance, last);
      return;
    }
    const Vec2 onMap = (distance * middle.x) * direction;
    const Vec3 at = from + Vec3{onMap.x, onMap.y, distance * middle.y};
    const double along = std::abs(last - first) + distance * part.angle;
    visit(part, levelsAt(grid_.toTexels(at),
                         std::max(across * distance * middle.x, along / 2) / grid_.texel));
  };
  halve(halve, arc, distanceTo(arc.from), distanceTo(arc.to));
}

}  // namespace hearth
