#pragma once

#include <cstddef>
#include <optional>
#include <vector>

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
        known_(scene.level().lights.size()) {}

  struct Known {
    Shaft shaft;
    TargetVisibility outcome;
  };
  /// Of one of the lights that may shine on the mesh. Follows the shaft when it is first asked for.
  const Known& from(std::size_t light) {
    std::optional<Known>& known = known_[light];
    if (!known) {
      known.emplace(Known{Shaft(scene_), TargetVisibility::Unknown});
      known->outcome = known->shaft.follow(visibilities_.fine[light].shaftLight(),
                                           {box_, place_.sectors}, &place_.lights.shaftFrom(light));
    }
    return *known;
  }

 private:
  Scene scene_;
  const LightVisibilities& visibilities_;
  TargetBox box_;
  const MeshPlace& place_;
  std::vector<std::optional<Known>> known_;  ///< by index of light
};

}  // namespace hearth
