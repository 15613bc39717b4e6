#pragma once

#include <cstddef>
#include <span>

#include "level/light_source.h"
#include "light/sampling/sample_arrays.h"
#include "math/vec.h"

namespace hearth {

/// Loops over samples, as many at once as the processor's registers hold. The results are the same
/// to the bit on every processor.
struct BrightnessKernels {
  /// Metres from a light.
  void (*findDistances)(const SampleArrays& samples, std::size_t count, Vec3 light,
                        double* distances);
  /// intensity / (distance * falloff + 1), see LightSource::brightnessAt.
  void (*findLevels)(const double* distances, std::size_t count, double intensity, double falloff,
                     double* levels);
  /// On a curve of at least one point, see LightSource::brightnessAt.
  void (*findLevelsOnCurve)(const double* distances, std::size_t count,
                            std::span<const CurvePoint> curve, double* levels);
  /// Multiplies levels by the cosine of the angle between a normal of length 1 and the light.
  void (*applyCosine)(const SampleArrays& samples, const double* distances, std::size_t count,
                      Vec3 light, Vec3 normal, double* levels);
  /// Multiplies levels by the factor of a spot at the position of its light, see Spot::factor.
  void (*applySpot)(const SampleArrays& samples, const double* distances, std::size_t count,
                    Vec3 light, const Spot& spot, double* levels);
  /// Multiplies levels by the fraction of the light that is seen, and by 0 beyond `reach` metres.
  void (*applySeen)(const double* seen, const double* distances, std::size_t count, double reach,
                    double* levels);
  /// Adds levels times `fraction` to sums, each by the rules of LightSum.
  void (*addToSums)(const double* levels, std::size_t count, double fraction, double* sums);
  /// The means of sums of so many samples, see LightSum::mean.
  void (*findMeans)(const double* sums, std::size_t count, int samples, double* means);
};

/// The kernels for the widest registers of this processor.
const BrightnessKernels& brightnessKernels();

}  // namespace hearth
