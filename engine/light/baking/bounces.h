#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "level/bake_settings.h"
#include "level/scene.h"
#include "light/bake_progress.h"
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
  /// Whether any light bounces.
  bool haveLight() const { return lights_.size() > scene_.level().lights.size(); }

  /// Finds what the last bounce reflects, unless it is known: needed before anything asks for it.
  /// False after a request to stop. Extends the progress by the texels that it needs for that.
  bool find(BakeProgress& progress, const std::stop_token& stop = {});
  /// That; null if no light bounces.
  const Irradiance* irradiance() const;

 private:
  Scene scene_;  ///< without it
  BakeSettings settings_;
  int threads_;
  std::vector<LightSource> lights_;
  std::optional<Irradiance> irradiance_;
};

}  // namespace hearth
