#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/gather/irradiance.h"
#include "light/gather/slice.h"
#include "light/gather/small_areas.h"

namespace hearth {

/// The fraction of a light that is an area which makes so many levels in its brightest channel; all
/// if it makes less. Light that bounces has no whole.
inline double fractionFor(double levels, const LightSource& light) {
  if (light.isBounced) return levels;
  return levels / std::max(levels, light.intensity * light.greatestFactor());
}

/// How closely an AreaVisibility looks. All but the number of slices are levels.
struct GatherAccuracy {
  int firstSlices = 8;  ///< around a point: a power of 2, at most 64
  /// Steps between slices are halved while that changes more, ...
  double change = 0.1;
  /// ... or so much of light that bounces, of which many small changes make up for one another.
  double changeOfBounced = 1;
  double missed = 1;  ///< what is narrow may be missed between two slices if it gives less

  /// With so many times the levels.
  GatherAccuracy times(double factor) const {
    return {firstSlices, factor * change, factor * changeOfBounced, factor * missed};
  }

  double changeOf(const LightSource& light) const {
    return light.isBounced ? changeOfBounced : change;
  }
};

/// Answers which fraction of the light of areas arrives at a point: the cosine to its normal,
/// integrated over the directions in which it first meets the area, over pi. So all light of the
/// sky arrives at level ground in the open. Of light that bounces, whose intensity is a level, it
/// answers how many levels arrive. (Radiosity calls it a form factor: M. Cohen and J.
/// Wallace, "Radiosity and Realistic Image Synthesis", 1993, chapter 4.)
///
/// In each of some compass directions a slice tells the slopes in question, over which the cosine
/// is integrated exactly. Between compass directions the trapezoid rule halves its steps while that
/// changes something, and where a surface that shines, or a window to the sky, is narrower than a
/// step.
class AreaVisibility {
 public:
  /// Of all lights of the scene that are areas. `solidMaskedMiddles`: see BakeSettings.
  AreaVisibility(const Scene& scene, bool solidMaskedMiddles, GatherAccuracy accuracy = {});
  /// What light bounces: needed before anything is asked if any does. Keeps a reference.
  void setIrradiance(const Irradiance& irradiance) { irradiance_ = &irradiance; }

  /// Those lights, by index, rising.
  const std::vector<std::size_t>& lights() const { return slice_.lights().lights(); }
  /// The place of one of them among them.
  std::size_t placeOf(std::size_t light) const { return slice_.lights().placeOf(light); }

  /// At a point of a surface on the border of the air of a sector: the fraction of each, in their
  /// order. Adds the number of slices to `slices`, and the sectors that these enter to `met`,
  /// if any.
  void findOnSurface(Vec3 point, SectorId sector, Vec3 normal, std::span<double> fractions,
                     std::int64_t& slices, SectorSet* met = nullptr);
  /// The same for a point of a mesh, in the air of a sector, on faces of some normals: first the
  /// fractions of all lights on the first.
  void findOnMesh(Vec3 point, SectorId sector, std::span<const Vec3> normals,
                  std::span<double> fractions, std::int64_t& slices, SectorSet* met = nullptr);
  /// Of a point inside the air of a sector: of all directions, those that end in the area.
  void findFromAir(Vec3 point, SectorId sector, std::span<double> fractions, std::int64_t& slices);

 private:
  struct Step;
  class Receiver;
  struct InDirection;

  void findBefore(const SliceStart& start, std::span<const Vec3> normals,
                  std::span<double> fractions, std::int64_t& slices, SectorSet* met);
  template <typename InSlice>
  void integrate(const SliceStart& start, InSlice&& inSlice, double whole,
                 std::span<double> fractions, std::int64_t& slices, SectorSet* met);
  void addAreas(const InDirection& at, const std::vector<AreaInSlice>& areas,
                std::span<double> sums) const;
  void addBounced(const InDirection& at, const AreaInSlice& area, std::span<double> sums) const;
  void setLimits(std::size_t values, double whole);
  bool hidesSmallArea(const Step& step) const;
  template <typename InSlice>
  void addStep(const Step& step, const InSlice& inSlice, std::int64_t& slices);
  template <typename InSlice>
  std::size_t slice(int number, const InSlice& inSlice, std::int64_t& slices);

  Scene scene_;
  GatherAccuracy accuracy_;
  Slice slice_;
  const Irradiance* irradiance_ = nullptr;
  SmallAreas small_;
  std::vector<double> changes_;  ///< of the fraction of each, that are worth more slices
  std::vector<double> limits_;   ///< the same of the sums at hand
  std::vector<double> worth_;    ///< fractions of each for which what is small is looked for
  std::vector<CompassInterval> narrow_;  ///< around the point at hand
  std::vector<std::size_t> atFirst_;     ///< where values of the first slices begin
  std::vector<double> inSlices_;         ///< of those of the point at hand, one after the other
  std::vector<double> sums_;             ///< of values of lights, and of what could be seen
};

}  // namespace hearth
