#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "light/beam_tree/beam.h"
#include "light/sampling/sample_arrays.h"
#include "math/vec.h"

/// Loops over beams and samples, as many at once as the processor's registers hold. The results are
/// the same to the bit on every processor.
namespace hearth {

/// Vectors from a light to the one to eight corners of a box of points. Unused entries repeat the
/// first.
struct CornerOffsets {
  double x[8];
  double y[8];
  double z[8];
  std::size_t count = 8;
};

/// The upright planes between which beams lie, for findSpanning(): their normals in plan, into the
/// beam, each coordinate in an array of its own.
struct BeamSides {
  const double* beginX;
  const double* beginY;
  const double* endX;
  const double* endY;
};

/// The answer of findStraddled() if all corners are behind a bound.
inline constexpr std::uint32_t kBehindBound = std::uint32_t{1} << 31;
/// Its bits for bounds. The last one also stands for all bounds that follow.
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

/// A beam that findSpanning() finds.
struct SpanningBeam {
  std::uint32_t index;
  std::uint32_t straddled;  ///< which of its sides may have some corners behind it: 1 and 2

  friend bool operator==(const SpanningBeam&, const SpanningBeam&) = default;
};

/// The number of bounds of a beam that may part some samples. If the beam `isDoubtful`, no sample
/// in it is certainly lit.
struct StraddledBounds {
  std::size_t count;
  bool isDoubtful;
};

/// Marks a sample whose visible fraction the beams cannot decide.
inline constexpr double kUnknownFraction = -1;

struct BeamKernels {
  /// The beams without a side that has all corners behind it, by rising indices. Returns their
  /// number; `spanning` has room for `count`. `margin` is that of rays to the corners.
  std::size_t (*findSpanning)(const CornerOffsets& corners, const BeamSides& beams,
                              std::size_t count, double margin, SpanningBeam* spanning);
  /// A bit for each bound of a beam that may have some corners behind it; or kBehindBound. Tests
  /// only the bounds with a bit in `asked`.
  std::uint32_t (*findStraddled)(const CornerOffsets& corners, const BeamBounds& bounds,
                                 std::uint32_t asked, double margin, double reach);
  /// For each sample 1 if one of the beams of a point light certainly contains it, 0 if none can,
  /// and else kUnknownFraction. `bounds` holds those of all beams, one beam after the other. Reads
  /// and writes up to SampleArrays::kMaxLanes more than `count`.
  void (*findSeen)(const SampleArrays& samples, std::size_t count, Vec3 light,
                   std::span<const StraddledBounds> beams, const BoundingPlane* bounds,
                   double* seen);
};

/// The kernels for the widest registers of this processor.
const BeamKernels& beamKernels();

}  // namespace hearth
