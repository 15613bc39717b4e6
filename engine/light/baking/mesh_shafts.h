#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/baking/light_visibility.h"
#include "light/rays/shaft.h"

namespace hearth {

/// Shafts from the lights to a part of a mesh. Rays to it need only ask the walls that these meet.
class MeshShafts {
 public:
  /// Keeps references. `sectors` are those that the mesh is in.
  MeshShafts(const Scene& scene, const LightVisibilities& visibilities, const TargetBox& box,
             std::span<const SectorId> sectors)
      : scene_(scene),
        visibilities_(visibilities),
        box_(box),
        sectors_(sectors),
        known_(scene.level().lights.size()) {}

  struct Known {
    Shaft shaft;
    TargetVisibility outcome;
  };
  /// Follows the shaft when it is first asked for.
  const Known& from(std::size_t light) {
    std::optional<Known>& known = known_[light];
    if (!known) {
      known.emplace(Known{Shaft(scene_), TargetVisibility::Unknown});
      known->outcome =
          known->shaft.follow(visibilities_.fine[light].shaftLight(), {box_, sectors_}, nullptr);
    }
    return *known;
  }

 private:
  Scene scene_;
  const LightVisibilities& visibilities_;
  TargetBox box_;
  std::span<const SectorId> sectors_;
  std::vector<std::optional<Known>> known_;  ///< by index of light
};

}  // namespace hearth
