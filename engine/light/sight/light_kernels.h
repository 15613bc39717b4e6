#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "light/beam_tree/beam.h"
#include "math/vec.h"

/// What is done with many samples, as many at once as the registers of a processor hold. Whatever
/// the processor, the results are the same to the bit.
namespace hearth {

/// Coordinates of samples in metres, each in an array of its own.
struct SampleArrays {
  const double* x;
  const double* y;
  const double* z;

  SampleArrays from(std::size_t first) const { return {x + first, y + first, z + first}; }
};

/// Vectors from a light to the corners of what holds some points, one to eight. Unused entries
/// repeat the first.
struct CornerOffsets {
  double x[8];
  double y[8];
  double z[8];
  std::size_t count = 8;
};

/// The upright planes between which beams lie, as findSpanning() takes them: their normals on the
/// map, into the beam, each coordinate in an array of its own.
struct BeamSides {
  const double* beginX;
  const double* beginY;
  const double* endX;
  const double* endY;
};

/// What findParting() answers where a bound has all corners behind it.
inline constexpr std::uint32_t kBehindBound = std::uint32_t{1} << 31;
/// The bits that it has for bounds: the last one stands for all that follow, too.
inline constexpr std::size_t kBoundBits = 31;
inline constexpr std::uint32_t kAllBounds = kBehindBound - 1;

/// A plane in coordinates relative to the light: a vector v is in front of it if
/// dot(normal, v) > offset. Within `slack` rounding decides; both are metres times the length of
/// the normal.
struct BoundingPlane {
  Vec3 normal;
  double offset;
  double slack;
};

/// How many bounds of a beam of light part some samples, perhaps. Where it `isDoubtful`, nothing in
/// it is lit for sure.
struct PartingBounds {
  std::size_t count;
  bool isDoubtful;
};

/// Marks a sample whose visible fraction the beams cannot decide.
inline constexpr double kUnknownFraction = -1;

struct LightKernels {
  /// The indices of beams that have no side with all corners behind it, in rising order. Returns
  /// how many they are; `spanning` has room for `count`. `margin` is that of rays to the corners.
  std::size_t (*findSpanning)(const CornerOffsets& corners, const BeamSides& beams,
                              std::size_t count, double margin, std::uint32_t* spanning);
  /// A bit for each of the bounds of a beam that has some corners behind it, perhaps; or
  /// kBehindBound. Of those alone that have a bit in `asked`.
  std::uint32_t (*findParting)(const CornerOffsets& corners, const BeamBounds& bounds,
                               std::uint32_t asked, double margin, double reach);
  /// For each of the samples 1 where one of the beams of a point of light holds it for sure, 0
  /// where none can, and else kUnknownFraction. The bounds of the beams follow one another.
  void (*findSeen)(const SampleArrays& samples, std::size_t count, Vec3 light,
                   std::span<const PartingBounds> beams, const BoundingPlane* bounds, double* seen);
  /// Metres from a light.
  void (*findDistances)(const SampleArrays& samples, std::size_t count, Vec3 light,
                        double* distances);
  /// intensity / (distance * falloff + 1), see LightSource::brightnessAt.
  void (*findLevels)(const double* distances, std::size_t count, double intensity, double falloff,
                     double* levels);
  /// Multiplies levels by the cosine of the angle between a normal of length 1 and the light.
  void (*applyCosine)(const SampleArrays& samples, const double* distances, std::size_t count,
                      Vec3 light, Vec3 normal, double* levels);
  /// Multiplies levels by the fraction that is seen of the light: nothing from `reach` metres on.
  void (*applySeen)(const double* seen, const double* distances, std::size_t count, double reach,
                    double* levels);
  /// Adds levels times `fraction` to sums, each by the rules of LightSum.
  void (*addToSums)(const double* levels, std::size_t count, double fraction, double* sums);
};

/// Those for the widest registers that this processor has.
const LightKernels& lightKernels();

}  // namespace hearth
