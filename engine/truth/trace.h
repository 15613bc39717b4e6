#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <variant>

#include "level/level.h"

namespace hearth {

/// A point of a surface: which surface, where, and its normal.
struct SurfacePoint {
  SurfaceKind kind;
  SectorId sector;                   ///< whose air the surface bounds: the viewer's side
  std::optional<SegmentId> segment;  ///< of `sector`; upright surfaces and sky steps only
  Vec3 point;                        ///< metres
  Vec3 normal;                       ///< unit, into the air
  std::optional<SurfaceId> sprite = std::nullopt;    ///< which one, if it is a sprite
  std::optional<SurfaceId> mesh = std::nullopt;      ///< which one, if it is a mesh
  std::optional<std::uint32_t> face = std::nullopt;  ///< of a mesh: index into Level::meshFaces
};

/// Where a ray ends.
struct TruthHit : SurfacePoint {
  double t = 0;               ///< ray parameter: point = origin + t * direction
  std::uint32_t subWall = 0;  ///< of a stack, bottom to top
  /// None only for light that ends beyond a sky, on the endless side of a portal.
  std::optional<TextureMapping> texture;
  /// Image coordinates before repeat and offset: metres to the right and down of the image's
  /// corner (sky: turns, and tangents below the image's top edge).
  Vec2 imageMetres;
};

enum class RayKind {
  Look,    ///< ends at skies
  Light,   ///< passes skies, beyond which the sides of sky sectors are endless; masked
           ///< middle textures stop it from either side
  Gather,  ///< ends at skies; masked middle textures stop it from either side
};

/// Follows the ray from `origin` through portals, stacks and flat portals to the first surface that
/// it meets from its front. `origin` lies strictly inside the air of `sector` (see nudgedInside),
/// or for light also above its sky ceiling or below its sky floor; `direction` is not null and of
/// any length. None only for light that leaves the level through a sky.
///
/// Works only from authored data (segments, flats, slopes, flat portals), so that derived data can
/// be compared with it.
std::optional<TruthHit> trace(const Level& level, SectorId sector, Vec3 origin, Vec3 direction,
                              RayKind kind);

/// The part of a ray that is in the air of one sector, from where it enters to where it leaves.
struct AirStretch {
  SectorId sector;
  double tEnter;  ///< ray parameters, as in TruthHit
  double tLeave;
};

/// What is met in a stretch of air; none if it is empty. Where a function may get none of these,
/// all air is empty.
using MeetInAir = std::function<std::optional<TruthHit>(const AirStretch&)>;

/// As `trace` for a look, but asks at each stretch of air, from the origin on, what is met in it.
TruthHit traceLook(const Level& level, SectorId sector, Vec3 origin, Vec3 direction,
                   const MeetInAir& meetInAir);

/// As `traceLook`, but for light that comes from the surface that the ray meets.
TruthHit traceGather(const Level& level, SectorId sector, Vec3 origin, Vec3 direction,
                     const MeetInAir& meetInAir = {});

/// The first surface that light from `origin`, as above, meets on its way to a point of a surface
/// of the level. A masked middle texture is met at that point even if it has a hole there.
std::optional<TruthHit> traceLight(const Level& level, SectorId sector, Vec3 origin,
                                   const SurfacePoint& to, const MeetInAir& meetInAir = {});

/// The surface that stops light on the straight line from `origin`, as above, to a point of a mesh,
/// or the sector in which it arrives there. No surface stops it within kArrival of that point: so
/// it arrives also where the mesh touches the level.
std::variant<TruthHit, SectorId> traceLightToMesh(const Level& level, SectorId sector, Vec3 origin,
                                                  Vec3 end, const MeetInAir& meetInAir = {});

/// The sector in which light arrives on the straight line from `origin`, as above, to `end`; none
/// if a surface stops it before.
std::optional<SectorId> sectorAt(const Level& level, SectorId sector, Vec3 origin, Vec3 end,
                                 const MeetInAir& meetInAir = {});

/// Whether two points are on one surface; of meshes, on one face.
bool isSameSurface(const SurfacePoint& a, const SurfacePoint& b);

}  // namespace hearth
