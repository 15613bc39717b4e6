#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "level/locate.h"
#include "level/scene.h"
#include "light/baking/light_visibility.h"
#include "light/baking/lights_on_mesh.h"
#include "light/rays/shaft.h"

namespace hearth {

/// Shafts from the lights to a part of a mesh. Rays to it need only ask the walls that these meet.
class MeshShafts {
 public:
  /// Keeps references to `visibilities` and `place`.
  MeshShafts(const Scene& scene, const LightVisibilities& visibilities, const TargetBox& box,
             const MeshPlace& place)
      : scene_(scene),
        visibilities_(visibilities),
        box_(box),
        place_(place),
        known_(scene.lights().size()),
        toPoint_{Shaft(scene), TargetVisibility::Unknown} {}

  struct Known {
    Shaft shaft;
    TargetVisibility outcome;
  };
  /// Of one of the lights that may shine on the mesh. Follows the shaft when it is first asked for.
  const Known& from(std::size_t light) {
    std::optional<Known>& known = known_[light];
    if (!known) {
      known.emplace(Known{Shaft(scene_), TargetVisibility::Unknown});
      known->outcome = known->shaft.follow(visibilities_.fine(light).shaftLight(),
                                           {box_, place_.sectors}, &place_.lights.shaftFrom(light));
    }
    return *known;
  }

  /// The same to one point of the part, if many rays go there: those of a ball. `normal`: of what
  /// it lies on, if on a plane. Valid until the next call.
  const Known& toPoint(std::size_t light, Vec3 point, Vec3 normal) {
    const Known& all = from(light);
    const ShaftLight& from = visibilities_.fine(light).shaftLight();
    if (from.radius == 0 || all.outcome != TargetVisibility::Unknown) return all;
    toPoint_.outcome = toPoint_.shaft.follow(
        from, {TargetBox::ofPoint(point, normal), sectorsAt(point)}, &all.shaft);
    return toPoint_;
  }

 private:
  /// One of the mesh's sectors in which a point is, if that is known, or all of them.
  std::span<const SectorId> sectorsAt(Vec3 point) const {
    for (std::size_t i = 0; place_.sectors.size() > 1 && i < place_.sectors.size(); ++i)
      if (contains(scene_, scene_[place_.sectors[i]], point, 0))
        return place_.sectors.subspan(i, 1);
    return place_.sectors;
  }

  Scene scene_;
  const LightVisibilities& visibilities_;
  TargetBox box_;
  const MeshPlace& place_;
  std::vector<std::optional<Known>> known_;  ///< by index of light
  Known toPoint_;
};

}  // namespace hearth
