#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "level/moved_geometry.h"
#include "level/mover.h"
#include "light/blended_light.h"
#include "math/parallel.h"
#include "render/renderer.h"
#include "settings/mover_light.h"
#include "viewer/walk/rest_light.h"

namespace hearth {

/// What frames show of a level whose movers move: its flats at any heights, in light that is
/// blended from the states at rest around them. A state whose light is not known yet has that of
/// the known one in which movers stand nearest.
class MovedView {
 public:
  /// At first the light of `still` is known, which draws the level as authored. It must outlive
  /// this, its level and geometry, too. No more states are kept than `settings` say, unless more
  /// show at once.
  MovedView(const Scene& authored, const Renderer& still, const MoverLightSettings& settings = {});
  MovedView(const MovedView&) = delete;
  MovedView& operator=(const MovedView&) = delete;

  Scene scene() const { return geometry_.scene(); }
  const Renderer& renderer() const { return renderer_; }

  /// Moves flats to where they stand with movers at these shares.
  void moveTo(std::span<const double> shares);
  /// Lights them so. Takes memory only where another mover sets out or arrives.
  void light(Workers* workers);

  /// From now on this light is known, of the same level. The one that was not needed for longest is
  /// forgotten where too many are kept.
  void add(std::shared_ptr<const RestLight> rest);
  /// The states around the shares of now whose light is not known, by falling share of their
  /// movers.
  std::span<const std::vector<double>> wanted() const { return wanted_; }

 private:
  struct Known {
    std::vector<double> shares;
    LightAtRest at;
    std::shared_ptr<const RestLight> rest;  ///< which owns it; null for the level as authored
    std::size_t lastUse = 0;                ///< of states that were set
  };

  void setStates();
  void forgetOldest();
  std::size_t nearestKnown(std::span<const double> shares) const;

  MovedGeometry geometry_;
  MoverLightSettings settings_;
  std::vector<Known> known_;
  std::size_t uses_ = 0;  ///< how often states were set
  BlendedLight light_;
  Renderer renderer_;

  RestStates around_;                  ///< the shares of now
  RestStates blended_;                 ///< for which `light_` has its states
  std::vector<std::size_t> sourceOf_;  ///< by these: the index of the known light
  std::vector<double> weights_;        ///< by known light that is blended
  std::vector<std::vector<double>> wanted_;
  bool isLit_ = false;
};

}  // namespace hearth
