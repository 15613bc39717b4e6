#pragma once

#include <optional>

namespace hearth {

/// How a bake samples light. Files give it, the command line overrides it.
struct BakeSettings {
  double texel = 0.125;  ///< metres
  /// Per texel, a square number; none for as many as the edges of shadows need.
  std::optional<int> samples = 1;
  /// Per sample and light with a radius, a square number; 0 for lights without one. 36 are the
  /// fewest that are less than a level off beside straight edges.
  int softSamples = 36;
  /// Levels. From where on a light has no more than so many, it is left out.
  double cutOff = 0;
  bool lambert = false;  ///< multiply by the cosine at the surface
  int bounces = 0;
  double reflectance = 1;  ///< 0..1, of all textures, by which their own is multiplied
  /// Levels, more than 0: how far off interpolated light of the sky and of surfaces that shine may
  /// be. Light that bounces may be three times as far off.
  double gatherError = 1;
  /// No light passes through the holes of masked middle textures, and no texel is asked for one.
  bool solidMaskedMiddles = false;

  friend bool operator==(const BakeSettings&, const BakeSettings&) = default;
};

}  // namespace hearth
