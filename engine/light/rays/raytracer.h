#pragma once

#include <optional>

#include "level/scene.h"
#include "light/rays/face_point.h"
#include "light/rays/id_set.h"
#include "light/rays/shaft.h"
#include "light/rays/sky_shaft.h"

namespace hearth {

/// Answers whether a light sees a point: follows the straight line from the light through the
/// openings of the sectors. The line enters sectors only through links. So no light leaks through
/// joints of walls, and sectors that merely overlap in space do not meet.
class Raytracer {
 public:
  /// `solidMaskedMiddles`: see BakeSettings.
  explicit Raytracer(const Scene& scene, bool solidMaskedMiddles = false)
      : scene_(scene), solidMaskedMiddles_(solidMaskedMiddles) {}

  /// Where a line starts.
  struct Source {
    Vec3 position;  ///< inside `sector` (above or below it where that is sky), off its walls
    SectorId sector;
  };
  static Source sourceOf(const Scene& scene, const LightSource& light);

  /// True when the line from the source first meets a surface at `target`, a point on the border of
  /// the air of `sector`, and no mesh before that. The caller has made sure that the surface there
  /// faces the source.
  /// `met`, if any, gets the sectors that the line enters.
  bool sees(const Source& source, Vec3 target, SectorId sector, SectorSet* met = nullptr) const;
  /// The same for a ray of a shaft. It tests only the walls that the shaft meets.
  bool sees(const Source& source, Vec3 target, SectorId sector, const Shaft& shaft) const;

  /// The sector in which the line from the source arrives at a point of the air; none if it
  /// meets a surface before. It goes through meshes.
  std::optional<SectorId> sectorAt(const Source& source, Vec3 point,
                                   SectorSet* met = nullptr) const;

  /// True when light from the source arrives at a point of the air in `sector`: meshes stop it,
  /// too.
  bool reaches(const Source& source, Vec3 point, SectorId sector) const;
  /// True when it arrives at a point of a mesh's face, in a sector that the mesh is in. The source
  /// is in front of the face, and the ray one of the shaft.
  bool sees(const Source& source, const FacePoint& target, const Shaft& shaft) const;

  /// Whether the line from a point of a surface, on the border of the air of its sector, or from
  /// one of the air first meets a sky in a direction of length 1, which leads before the surface.
  /// `met` as above.
  bool seesSky(const Source& point, Vec3 direction, SectorSet* met = nullptr) const;
  /// The same for a ray of a shaft.
  bool seesSky(const Source& point, Vec3 direction, const SkyShaft& shaft) const;
  /// The same from a point of a mesh's face, and in the air of its sector: nudgedInside.
  bool seesSky(const Source& start, const FacePoint& point, Vec3 direction,
               const SkyShaft& shaft) const;

  /// Whether the line along a surface's normal, from a point of the surface on the border of the
  /// air of `sector`, first meets the back of a face: the point lies inside a mesh. Meshes that
  /// cast no shadow do not count, nor do two-sided ones, which have no inside.
  /// `met` as above.
  bool isInsideMesh(Vec3 point, Vec3 normal, SectorId sector, SectorSet* met = nullptr) const;
  /// The way that such a line takes: past all meshes in the sector. Zero if none lies that way.
  Vec3 pastMeshes(Vec3 point, Vec3 normal, SectorId sector) const;

 private:
  Scene scene_;
  bool solidMaskedMiddles_;
};

}  // namespace hearth
