#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/gather/irradiance.h"

namespace hearth {

/// The light that bounces, as a bake of `settings.bounces` of them has it: a sum of the light of
/// ever more reflections. (So is the solution of the rendering equation: J. Kajiya, "The Rendering
/// Equation", 1986.) All bounces but the last are found by an IrradianceBake. The last is found
/// where the bake asks for it.
class Bounces {
 public:
  /// Keeps references to the scene's parts.
  Bounces(const Scene& scene, const BakeSettings& settings, int threads);
  Bounces(const Bounces&) = delete;
  Bounces& operator=(const Bounces&) = delete;

  /// The scene, lit by this light, too, if there is any. Not valid beyond this object.
  Scene scene() const { return scene_.litBy(lights_); }
  /// What the last bounce reflects; null without bounces. The first call finds it; any thread may
  /// call it.
  const Irradiance* irradiance() const;

 private:
  Scene scene_;  ///< without it
  BakeSettings settings_;
  int threads_;
  std::vector<LightSource> lights_;
  mutable std::once_flag once_;
  mutable std::optional<Irradiance> irradiance_;
};

}  // namespace hearth
