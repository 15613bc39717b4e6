#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "agreement/common_edges.h"
#include "agreement/mesh_pieces.h"
#include "truth/trace.h"

namespace hearth::agreement {

/// Of the lightmap of a surface, which is given by its index.
struct Texel {
  std::size_t surface;
  std::uint32_t piece;  ///< of a mesh: the first face of a piece; of all else 0
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

/// The four texels whose centres are around a point of a surface. A small face of a mesh has its
/// corners for the centres of three; the fourth continues these.
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
  std::optional<TexelPatch> around(const SurfacePoint& hit);

  /// Those that count: none where all are left out, or of the fourth texel of a small face.
  std::vector<TexelSample> samplesOf(const Texel& texel);

  /// The texel itself or, if all its samples are left out, the nearest one that has some.
  Texel nearestWithSamples(const Texel& texel);

  bool isFourthOfSmallFace(const Texel& texel);

  /// Whether a hair decides which samples it has, or it has none: then hairs decide which texel is
  /// the nearest one that has some.
  bool isInDoubt(const Texel& texel);

  /// Whether none of its samples is left out.
  bool hasAllSamples(const Texel& texel);

  /// The points of the same surface at a distance from this one, one in each of 16 directions where
  /// the surface reaches so far.
  std::vector<SurfacePoint> ringAround(const SurfacePoint& place, double radiusMetres);

 private:
  std::optional<TexelPatch> aroundOnMesh(const SurfacePoint& hit);
  bool hasCornersForSamples(const Texel& texel);
  std::vector<TexelSample> allSamplesOf(const Texel& texel);
  std::vector<TexelSample> meshSamplesOf(const Texel& texel);
  bool isLeftOut(const SurfacePoint& place) const;
  std::vector<TexelSample> cornerOf(const MeshPiece& piece, std::size_t corner) const;
  bool isOnLightmap(const Texel& texel);
  std::optional<std::size_t> surfaceOf(const SurfacePoint& hit) const;
  bool areInOnePlane(std::size_t a, std::size_t b) const;
  const std::vector<CommonEdge>& continuationsOf(std::size_t surface);
  std::vector<std::size_t> reachableFrom(std::size_t surface, Vec3 sample, double distance);
  TexelSample sampleAt(std::size_t surface, Vec3 center);

  Scene scene_;
  MeshPieces meshes_;
  std::vector<std::optional<Panel>>
      panels_;                 ///< by index of surface; none for skies, and where nothing shows
  std::vector<Vec3> corners_;  ///< of the panels
  std::vector<Axes> grids_;    ///< by index of surface; texel (0, 0) at their origins
  std::vector<std::optional<std::vector<CommonEdge>>> continuations_;  ///< by index, when asked for
};

}  // namespace hearth::agreement
