#pragma once

#include <optional>

#include "viewer/inspect/inspect.h"

namespace hearth {

/// Levels that show clearly: a quarter of full light.
inline constexpr double kClearLevel = 64;

/// The change to a light that is too weak which brings `kClearLevel`, in its brightest channel, to
/// the place, if nothing stands between. Rounded to two digits, towards more light.
struct Remedy {
  /// For a light without a curve: the first of these that is enough, not both.
  std::optional<double> falloff = {};
  std::optional<double> intensity = {};
  /// For a light with a curve: the level that it needs at this distance.
  std::optional<double> curveLevel = {};
};

/// None for a light that is black.
std::optional<Remedy> remedyFor(const LightSource& light, const LightFinding& finding);

}  // namespace hearth
