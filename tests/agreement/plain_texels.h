#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "agreement/common_edges.h"
#include "truth/trace.h"

namespace hearth::agreement {

/// The four texel centres around a point of a surface.
struct TexelPatch {
  std::array<Vec3, 4> centers;          ///< (i, j), (i+1, j), (i, j+1), (i+1, j+1)
  std::array<SurfacePoint, 4> samples;  ///< where they take their light
  double fs;                            ///< share of the way from i to i+1
  double ft;                            ///< ... from j to j+1

  /// What each counts for at the point.
  std::array<double, 4> weights() const {
    return {(1 - fs) * (1 - ft), fs * (1 - ft), (1 - fs) * ft, fs * ft};
  }
};

/// Where the texels of lightmaps lie and where their samples take their light, from the words of
/// the file format alone and with nothing of the bakery: every surface is a polygon, and every pair
/// of them is tried. Slow, and meant to be plain.
class PlainTexels {
 public:
  /// Keeps a reference to the level. Samples are texel centres: for bakes of one sample a texel.
  explicit PlainTexels(const Level& level);

  /// None where the hit is on no surface that takes light.
  std::optional<TexelPatch> around(const SurfacePoint& hit);

  /// The points of the same surface at a distance from this one, one in each of 16 directions where
  /// the surface reaches so far.
  std::vector<SurfacePoint> ringAround(const SurfacePoint& place, double radiusMetres) const;

 private:
  struct Texel {
    std::size_t surface;
    double i;
    double j;
    auto operator<=>(const Texel&) const = default;
  };

  std::optional<std::size_t> surfaceOf(const SurfacePoint& hit) const;
  const std::vector<CommonEdge>& continuationsOf(std::size_t surface);
  std::vector<std::size_t> reachedFrom(std::size_t surface, Vec3 sample, double distance);
  SurfacePoint placeOf(std::size_t surface, Vec3 sample);
  Vec3 centerOf(const Texel& texel) const;
  const SurfacePoint& sampleAt(const Texel& texel);

  const Level& level_;
  std::vector<std::optional<Panel>> panels_;  ///< by index of surface; none for skies
  std::vector<Vec3> corners_;                 ///< of the panels
  std::vector<Axes> grids_;  ///< by index of surface; texel (0, 0) at their origins
  std::vector<std::optional<std::vector<CommonEdge>>> continuations_;  ///< by index, when asked for
  std::map<Texel, SurfacePoint> samples_;
};

}  // namespace hearth::agreement
