#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/gather/area_lights.h"
#include "light/gather/plan_view.h"
#include "light/gather/slice.h"
#include "light/rays/id_set.h"
#include "math/box3.h"

namespace hearth {

class Hash;

/// Compass directions, in degrees: 0 along +x, 90 along +y.
struct CompassInterval {
  double from;   ///< 0..360
  double width;  ///< beyond `from`
};

/// Where a level's surfaces are that shine, and its skies: so that a point can look closely at what
/// is narrow as seen from it.
class SmallAreas {
 public:
  SmallAreas(const Scene& scene, const AreaLights& lights);

  /// Adds to `found` the directions in which a point may see surfaces that shine, or a sky through
  /// walls between sectors, which fill less than `widest` degrees of the compass around it: if they
  /// may give it more than these fractions of their light, which are by the places of lights. Adds
  /// the sectors that decide this to `met`, if any.
  void findAround(const SliceStart& from, double widest, std::span<const double> least,
                  std::vector<CompassInterval>& found, SectorSet* met);

  /// Adds all that `findAround` depends on, except the sectors that a point may see.
  void addTo(Hash& hash) const;

 private:
  struct Shining {
    AreaLights::Place light;
    std::vector<SectorId> sectors;  ///< that it is in
    Box3 box;
    double area;  ///< square metres, at most
  };

  static void addShining(const Scene& scene, const AreaLights& lights,
                         std::vector<Shining>& shining);
  static void addSurface(const Scene& scene, SurfaceId id, AreaLights::Place light,
                         std::vector<Shining>& shining);
  static void addFaces(const Level& level, const AreaLights& lights, const Mesh& mesh,
                       const std::vector<SectorId>& sectors, std::vector<Shining>& shining);

  struct Candidate {
    const Shining* shining;
    CompassInterval directions;
  };

  std::shared_ptr<const std::vector<Shining>> shining_;  ///< copies share it
  std::optional<AreaLights::Place> sky_;
  std::optional<PlanView> view_;  ///< none if nothing shines and no sky does
  std::vector<Candidate> candidates_;
};

}  // namespace hearth
