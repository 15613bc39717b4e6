#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "level/scene.h"
#include "light/bakery.h"
#include "truth/truth_light.h"

namespace hearth {

/// A texel of a lightmap, and the point in its middle at which truth can be asked for its light.
struct LightPlace {
  SurfaceId map;  ///< whose lightmap it is
  int i;          ///< texel of it, as Lightmap::at takes it
  int j;
  SurfacePoint point;
};

/// Finds texels of a level that can be held against truth.
class LightPlaces {
 public:
  /// Keeps references. `baked` tells the texels; its light does not count.
  LightPlaces(const Scene& scene, const BakedLight& baked);

  /// A texel of a surface; none if its middle is beyond the surface or takes light of another
  /// place.
  std::optional<LightPlace> onSurface(SurfaceId id, int i, int j) const;
  /// A texel of a patch of a mesh; none if its middle is on none of the patch's faces or takes
  /// light of another place.
  std::optional<LightPlace> onPatch(std::uint32_t mesh, const LitMesh::Patch& patch, int i,
                                    int j) const;
  /// For truth: a point of a face, by its index into Level::meshFaces; none if it is not in the air
  /// of any of the mesh's sectors.
  std::optional<SurfacePoint> onFace(std::uint32_t mesh, std::uint32_t face, Vec3 point) const;

  /// Wanted texels of surfaces and patches, each as likely as any other, the same in each call:
  /// `count`, or fewer if hardly any texel is wanted and can be held against truth.
  std::vector<LightPlace> some(std::size_t count,
                               const std::function<bool(const LightPlace&)>& isWanted) const;

 private:
  Scene scene_;
  const BakedLight& baked_;
  std::vector<std::vector<SectorId>> sectors_;  ///< by mesh
};

}  // namespace hearth
