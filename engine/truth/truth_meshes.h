#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"
#include "truth/trace.h"

namespace hearth {

/// The meshes of a level. Each ray tries every face of those that are in its sector and whose box
/// it meets.
///
/// Works from what the author says of each, so that the renderer can be compared with it.
class TruthMeshes {
 public:
  /// Keeps a reference to the level.
  explicit TruthMeshes(const Level& level);

  /// What a look from `origin` meets of them in a stretch of air: the nearest face that is seen
  /// from its front, or of a two-sided mesh from either side; of two meshes at one depth the later.
  /// What bounds the stretch and is no nearer is behind them. `direction` goes 1 m deep before the
  /// camera: so the parameters of its ray are depths.
  ///
  /// Faces that share corners leave no gap between them. A hit's depth is between those of its
  /// face's corners, whatever the rounding.
  std::optional<TruthHit> nearest(Vec3 origin, Vec3 direction, const AirStretch& stretch) const;

  /// What stops light in the air of the line from `origin` to `end`, whose parameters go from 0 to
  /// 1: the nearest face of a mesh that casts a shadow, from whichever side. Not the face that is
  /// lit (its index in Level::meshFaces), nor what lies within kArrival of the end.
  ///
  /// Empty if the line is far from all meshes. Of use for as long as this.
  MeetInAir shadowsOn(Vec3 origin, Vec3 end,
                      std::optional<std::uint32_t> litFace = std::nullopt) const;

  /// What of a mesh that casts a shadow a ray of light meets in the air, from whichever side: the
  /// nearest face farther from the origin than kArrival. Not the face on which the ray starts.
  /// `direction` is of length 1. As above.
  MeetInAir facesAhead(Vec3 origin, Vec3 direction,
                       std::optional<std::uint32_t> startFace = std::nullopt) const;

  /// Whether a mesh is in a sector.
  bool isIn(SurfaceId mesh, SectorId sector) const;

 private:
  /// The corners of the smallest box around a mesh; crossed if it has no faces.
  struct Bounds {
    Vec3 min;
    Vec3 max;
  };

  static Bounds boundsOf(std::span<const MeshFace> faces);
  static bool mayMeet(const Bounds& bounds, Vec3 origin, Vec3 end);

  template <typename Line>
  MeetInAir nearestOn(const Line& line, double tEnd) const;

  const Level& level_;
  std::vector<Bounds> bounds_;           ///< of all meshes in their order
  std::vector<std::vector<bool>> isIn_;  ///< of all meshes in their order, by SectorId
};

}  // namespace hearth
