#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/baking/light_reach.h"
#include "light/baking/light_target.h"
#include "light/baking/sun_visibility.h"
#include "light/beam_tree/beam_tree.h"
#include "light/gather/area_visibility.h"
#include "light/grid/plane.h"
#include "light/rays/raytracer.h"
#include "math/box.h"

namespace hearth {

/// A grid of cells over a disc of radius 1, shared by all samples of a light. Many of its points
/// are equally far from the centre, so values that depend only on this distance are computed once.
struct DiscCells {
  explicit DiscCells(int across);

  /// How far a line through the disc is from its centre, p.
  struct Distance {
    double square;     ///< p^2
    double halfChord;  ///< sqrt(1 - p^2), in a ball of radius 1
  };
  static Distance distanceOf(Vec2 point);

  /// The distances of a list of points, each once.
  struct Distances {
    std::vector<Distance> all;
    std::vector<std::uint32_t> indexOfPoint;  ///< into `all`
  };
  static Distances distancesOf(const std::vector<Vec2>& points);

  std::vector<Vec2> corners;  ///< of the cells, row by row; moved to the nearest point of the disc
  Distances cornerDistances;
  Distances
      insideDistances;  ///< of the points where a cell is integrated (kWholeCell), cell by cell
};

/// Answers which fraction of a light with a place a point of a surface sees: all or nothing of a
/// point light, the fraction of its volume of a ball. If a wall runs through a ball, the part that
/// the centre does not see does not shine.
class LightVisibility {
 public:
  /// `softSamples` is for balls: the disc that a point sees of a ball is divided into about so many
  /// cells, as many across as down, and straight edges of shadows cut the cells exactly. If the
  /// ball is cut by more than planes, or the point is too near, 32 times as many points are spread
  /// over the ball instead. With 0 a ball is a point. `solidMaskedMiddles`: see BakeSettings.
  LightVisibility(const Scene& scene, const LightSource& light, int softSamples,
                  bool solidMaskedMiddles = false);
  ~LightVisibility();
  LightVisibility(LightVisibility&&) noexcept;

  /// 0..1. Adds the number of its rays to `rays`, and the sectors that they enter to `met`, if any.
  double seenFraction(const LightTarget& target, std::int64_t& rays,
                      SectorSet* met = nullptr) const;
  /// The same for a target of a shaft from `shaftLight()`, whose rays have this outcome.
  double seenFraction(const LightTarget& target, const Shaft& shaft, TargetVisibility outcome,
                      std::int64_t& rays) const;

  /// The same for a point inside the air of a sector, which no surface hides from any side.
  double seenFractionFromAir(Vec3 point, SectorId sector, std::int64_t& rays) const;

  /// The same for a point of a mesh's face, in the air of one of the mesh's sectors: a target of
  /// the shaft, whose rays have this outcome.
  double seenFraction(const FacePoint& target, const Shaft& shaft, TargetVisibility outcome,
                      std::int64_t& rays) const;
  /// The same for a corner of faces, none of which hides the light from it as far as it is behind
  /// the face.
  double seenFractionFromCorner(Vec3 corner, std::uint32_t mesh, const Shaft& shaft,
                                TargetVisibility outcome, std::int64_t& rays) const;

  const ShaftLight& shaftLight() const { return shaftLight_; }
  /// From now on the first call of `beams` finds the beam tree of a point light. Balls have none.
  void useBeams(const Scene& scene, const BeamLimits& limits);
  /// None unless useBeams() was called. Any thread may call it.
  const BeamTree* beams() const;
  /// Finds the beam tree now, if it is used and no thread has begun to find it. So threads that
  /// need the same trees begin with different ones, instead of waiting for one another.
  void prefetchBeams() const;
  /// The sectors that decide which part of the light shines: that of its centre, and all that lines
  /// from there to its other points enter.
  std::span<const SectorId> sectors() const { return sectors_; }

 private:
  template <typename Sees>
  double seenFractionBy(const LightTarget& target, Sees&& sees) const;
  template <typename Sees>
  double seenFractionBy(Vec3 point, Sees&& sees) const;
  bool isInFrontOfPlanes(Vec3 p) const;
  template <typename Sees>
  double seenOfDisc(Vec3 point, Sees&& sees) const;
  template <typename Sees>
  double seenOfPoints(Sees&& sees) const;

  Raytracer raytracer_;
  Raytracer::Source center_;
  double radius_;  ///< metres
  int cells_;      ///< along the disc's diameter
  DiscCells discCells_;
  std::vector<Plane> planes_;  ///< of the walls and flats that cut the ball
  /// Points spread evenly over the ball, without those that its centre does not see; the count
  /// includes them.
  std::vector<Raytracer::Source> points_;
  int pointCount_ = 0;
  /// Whether a ball shines exactly where it is in front of all planes.
  bool isCutByPlanesOnly_ = false;
  ShaftLight shaftLight_;
  struct Beams;
  std::unique_ptr<Beams> beams_;
  std::vector<SectorId> sectors_;
};

/// How points see the lights of a level: of a light with a place `fine` and `rough` tell, of a sun
/// `sun` and `roughSun`, of the sky `areas`. Each light is made ready when it is asked for: parts
/// of a bake need few of them. Any thread may ask.
class LightVisibilities {
 public:
  /// For a draft the light of areas is found at few places, as a source of light that bounces at
  /// fewer than for a bake.
  enum class Purpose { Bake, Source, Draft };
  /// Tells what light bounces; it is asked once that light is.
  using IrradianceSource = std::function<const Irradiance*()>;
  LightVisibilities(const Scene& scene, const BakeSettings& settings,
                    Purpose purpose = Purpose::Bake, IrradianceSource irradiance = {});
  /// Finds only beams to points of these parts of the map, one for each light, which may be empty.
  LightVisibilities(const Scene& scene, const BakeSettings& settings, const LightReach& itsReach,
                    std::vector<Box> regions, Purpose purpose = Purpose::Bake,
                    IrradianceSource irradiance = {});

  const LightReach reach;
  const LightVisibility& fine(std::size_t light) const { return *ready(light).fine; }
  /// With a quarter of the samples to a ball, for points that are averaged into one texel.
  const LightVisibility& rough(std::size_t light) const {
    const Light& its = ready(light);
    return its.rough ? *its.rough : *its.fine;
  }
  /// Null for what is no sun.
  const SunVisibility* sun(std::size_t light) const {
    return scene_.lights()[light].sun ? &*ready(light).sun : nullptr;
  }
  const SunVisibility& roughSun(std::size_t light) const { return *ready(light).roughSun; }
  /// A new one: each of the threads that ask needs its own.
  AreaVisibility areas() const;
  Purpose purpose() const { return purpose_; }
  double gatherError() const { return settings_.gatherError; }
  /// See LightVisibility; what has no place has no beams.
  void prefetchBeams(std::size_t light) const {
    if (scene_.lights()[light].hasPlace()) fine(light).prefetchBeams();
  }
  /// Those that decide which part of a light shines: none for what has no place.
  std::vector<SectorId> sectorsOf(std::size_t light) const;

 private:
  struct Light {
    std::once_flag once;
    std::atomic<bool> isReady = false;
    std::unique_ptr<const LightVisibility> fine;
    std::unique_ptr<const LightVisibility> rough;  ///< of a ball
    std::optional<SunVisibility> sun;
    std::optional<SunVisibility> roughSun;
  };

  static GatherAccuracy accuracyFor(Purpose purpose, double gatherError);
  const Light& ready(std::size_t light) const {
    if (!lights_[light].isReady.load(std::memory_order_acquire)) makeReady(light);
    return lights_[light];
  }
  void makeReady(std::size_t index) const;

  Scene scene_;
  BakeSettings settings_;
  std::vector<Box> regions_;  ///< none if beams lead everywhere
  Purpose purpose_;
  IrradianceSource irradiance_;
  AreaVisibility areas_;  ///< as all begin
  mutable std::vector<Light> lights_;
};

}  // namespace hearth
