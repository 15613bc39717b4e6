#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "level/surface.h"

namespace hearth::area_light {

/// How far baked light was off, at places that have some. In levels, 255 is full.
struct Errors {
  std::int64_t places = 0;
  std::int64_t far = 0;       ///< that were off by more than kFar, whatever the truth's own error
  double squares = 0;         ///< sum of the squares of the errors
  double squaresOfTruth = 0;  ///< of the standard errors of the truth
  double greatest = 0;        ///< error

  void add(double error, double errorOfTruth);
  Errors& operator+=(const Errors& other);
  double rms() const;
  /// Without what the truth itself is off by.
  double rmsOfBake() const;
};

inline constexpr double kFar = 4;

struct AreaTally {
  std::array<Errors, kSurfaceKindCount> kinds;
  std::int64_t levels = 0;
  std::int64_t slices = 0;   ///< of their bakes
  std::int64_t samples = 0;  ///< to which light was given
  std::int64_t dark = 0;     ///< places that get no light, and have next to none
  std::int64_t spills =
      0;  ///< places that get no light, and have more than kFar: between nodes of the lattice
  std::string worst;  ///< place
  std::string spill;  ///< the first

  void add(SurfaceKind kind, double baked, double truth, double errorOfTruth,
           const std::string& at);
  AreaTally& operator+=(const AreaTally& other);
  Errors sum() const;
};

/// By kind of surface.
std::string table(const AreaTally& tally);

}  // namespace hearth::area_light
