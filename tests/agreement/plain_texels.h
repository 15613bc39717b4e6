#pragma once

#include <array>
#include <optional>
#include <vector>

#include "agreement/common_edges.h"
#include "truth/trace.h"

namespace hearth::agreement {

/// Of the lightmap of a surface, which is given by its index.
struct Texel {
  std::size_t surface;
  double i;
  double j;
  auto operator<=>(const Texel&) const = default;
};

struct TexelSample {
  Vec3 center;         ///< of its part of the texel
  SurfacePoint place;  ///< where it takes its light
  /// Where it may take it as well: in the other corners of the surface that meet in the point
  /// nearest to it.
  std::vector<SurfacePoint> others;
};

/// The four texels whose centres are around a point of a surface.
struct TexelPatch {
  std::array<Texel, 4> texels;    ///< (i, j), (i+1, j), (i, j+1), (i+1, j+1)
  std::array<double, 4> weights;  ///< what each counts for at the point
};

/// Where the texels of lightmaps lie and where their samples take their light, from the words of
/// the file format alone and with nothing of the bakery: every surface is a polygon, and every pair
/// of them is tried. Slow, and meant to be plain.
class PlainTexels {
 public:
  /// Keeps the scene, whose level's bake must say how many samples a texel has.
  explicit PlainTexels(const Scene& scene);

  /// None where the hit is on no surface that takes light.
  std::optional<TexelPatch> around(const SurfacePoint& hit) const;

  std::vector<TexelSample> samplesOf(const Texel& texel);

  /// The points of the same surface at a distance from this one, one in each of 16 directions where
  /// the surface reaches so far.
  std::vector<SurfacePoint> ringAround(const SurfacePoint& place, double radiusMetres) const;

 private:
  std::optional<std::size_t> surfaceOf(const SurfacePoint& hit) const;
  bool areInOnePlane(std::size_t a, std::size_t b) const;
  const std::vector<CommonEdge>& continuationsOf(std::size_t surface);
  std::vector<std::size_t> reachableFrom(std::size_t surface, Vec3 sample, double distance);
  TexelSample sampleAt(std::size_t surface, Vec3 center);

  Scene scene_;
  std::vector<std::optional<Panel>>
      panels_;                 ///< by index of surface; none for skies, and where nothing shows
  std::vector<Vec3> corners_;  ///< of the panels
  std::vector<Axes> grids_;    ///< by index of surface; texel (0, 0) at their origins
  std::vector<std::optional<std::vector<CommonEdge>>> continuations_;  ///< by index, when asked for
};

}  // namespace hearth::agreement
