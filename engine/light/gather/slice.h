#pragma once

#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/gather/area_lights.h"
#include "light/gather/blocked_slopes.h"
#include "light/gather/face_envelope.h"
#include "light/rays/id_set.h"
#include "light/rays/plan_line.h"
#include "math/box3.h"

namespace hearth {

/// Where the lines of a slice begin.
struct SliceStart {
  Vec3 point;  ///< in the air of `sector`, or on its border
  SectorId sector;
  double slack;  ///< metres from the point within which no mesh stops a line
};

/// Slopes whose lines first meet an area.
struct AreaInSlice {
  SlopeRange slopes;
  std::optional<AreaLights::Place> light;  ///< that it shines with
  std::optional<SurfaceId> surface;        ///< none of a sky
  std::uint32_t face = 0;  ///< of a surface that is a mesh: index into Level::meshFaces
};

/// Follows all straight lines from a point in one compass direction at once: those of a vertical
/// half-plane. On the map they are one ray, which crosses the walls of sectors; how high each line
/// is there, its slope tells. So a sector's flats, and what opens in its wall, divide the slopes
/// into ranges, and only ranges are followed. (Ambient occlusion of depth buffers divides
/// directions so: L. Bavoil, M. Sainz and R. Dimitrov, "Image-Space Horizon-Based Ambient
/// Occlusion", 2008.)
class Slice {
 public:
  /// `solidMaskedMiddles`: see BakeSettings.
  Slice(const Scene& scene, bool solidMaskedMiddles)
      : scene_(scene), solidMaskedMiddles_(solidMaskedMiddles), lights_(scene) {}

  /// Those of the scene.
  const AreaLights& lights() const { return lights_; }

  /// The slopes, among `slopes`, of lines that first meet a sky that shines, the front of a surface
  /// that does, or where light bounces that of any, in no order. `direction` has length 1. `met`,
  /// if any, gets the sectors that lines enter. Valid until the next call.
  const std::vector<AreaInSlice>& areas(const SliceStart& start, Vec2 direction, SlopeRange slopes,
                                        SectorSet* met);

 private:
  /// Lines that are in one sector.
  struct Branch {
    SectorId sector;
    double tIn;            ///< metres on the map from where on they are in it
    double tAll;           ///< from where on all of them are
    const Segment* entry;  ///< through which they came, if through one
    SlopeRange slopes;
  };
  /// Of the border of a sector's air where lines leave it over its outline.
  struct Border {
    const Segment* segment;
    double t;
    AirColumn air;
  };
  /// A line in the slice's plane: how far along the map, and how high above the start.
  struct InPlane {
    Vec2 a;
    Vec2 b;
  };

  double slopeTo(double z, double t) const;
  void seeSky(SlopeRange slopes);
  void see(SlopeRange slopes, SurfaceId surface, TextureId texture, std::uint32_t face = 0);
  void see(SlopeRange slopes, SurfaceId surface);
  void advance(const Branch& branch);
  void divide(const Branch& branch, const Border& border, SlopeRange slopes);
  double whereAirEnds(const Branch& branch, const Border& border) const;
  void meetFlat(const Branch& branch, double t, SlopeRange slopes, bool isFloor);
  void crossFlatPortal(const Branch& branch, double t, SlopeRange slopes, bool isFloor);
  void findCrossings(std::span<const SectorId> members, double from, double to);
  SectorId memberAt(const FlatPortal& flatPortal, bool isFloor, double t) const;
  void meetWall(const Border& border, SlopeRange slopes);
  void seePieces(const Border& border, SlopeRange slopes);
  void seeSidewalls(const Opening& opening, const Border& border, SlopeRange slopes);
  SlopeRange slopesThrough(const LightOpening& opening, const Border& border) const;
  void passMiddles(const LightOpening& opening, const Border& border, SlopeRange slopes);
  void enter(const LightOpening& opening, double t, SlopeRange slopes);
  void meetMeshes(const Branch& branch, const Border& border);
  bool mayBlock(const Box3& box, const Branch& branch, const Border& border) const;
  std::optional<InPlane> cutOf(const MeshFace& face) const;
  void seeMiddle(SlopeRange slopes, SurfaceId surface);
  void seeFace(SlopeRange slopes, const FaceCut& cut);
  std::optional<InPlane> inAir(InPlane cut, const Branch& branch, const Border& border) const;
  void block(InPlane cut, const Branch& branch, const Mesh& mesh, const MeshFace& face);

  Scene scene_;
  bool solidMaskedMiddles_;
  AreaLights lights_;

  SliceStart start_{};
  Vec2 direction_{};
  std::optional<PlanLine> line_;
  SectorSet* met_ = nullptr;
  std::vector<Branch> branches_;   ///< that are left to follow
  FaceEnvelope faces_;             ///< of the meshes in the branch at hand
  BlockedSlopes middles_;          ///< by what is solid of those in the opening at hand
  std::vector<double> crossings_;  ///< of a flat portal's members
  std::vector<AreaInSlice> areas_;
};

}  // namespace hearth
