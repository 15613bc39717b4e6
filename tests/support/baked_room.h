#pragma once

#include <optional>
#include <string_view>

#include "light/bakery.h"
#include "load/load.h"

namespace hearth::test {

/// A level with its light, to be read at points of the world.
class BakedRoom {
 public:
  BakedRoom(std::string_view levelText, std::string_view lightsText, int threads = 2);
  explicit BakedRoom(LoadedLevel loaded, int threads = 2);

  const Level& level() const { return loaded_.level; }
  Scene scene() const { return loaded_.scene(); }
  const BakedLight& light() const { return light_; }

  /// Baked levels on the surface of a kind that shows at `p`, as the renderer would show them;
  /// 0 where it has no lightmap. `segmentSector` tells apart surfaces of several sectors.
  double at(SurfaceKind kind, Vec3 p, std::string_view sector = "", int channel = 0) const;

  /// The same on a mesh, at a point of a face whose front looks along `front`. Stops where none is.
  double onMesh(Vec3 p, Vec3 front, int channel = 0) const;

  std::optional<SurfaceId> surfaceAt(SurfaceKind kind, Vec3 p, std::string_view sector) const;

 private:
  LoadedLevel loaded_;
  BakedLight light_;
};

/// The same light, with all texels of lightmaps of which one was kept.
BakedLight withAllTexels(BakedLight light);

}  // namespace hearth::test
