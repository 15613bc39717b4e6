#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/beam_tree/beam_tree.h"
#include "light/grid/plane.h"
#include "light/sight/raytracer.h"

namespace hearth {

/// A point of a surface that is to be lit.
struct LightTarget {
  Vec3 point;       ///< where rays arrive: on the border of the air of `sector`
  SectorId sector;  ///< whose air the surface bounds
  Plane plane;      ///< the surface's, its normal into the air
};

/// Points of a disc of radius 1 that are asked for again and again. Many are equally far from its
/// centre, and what has to do with that is worked out once.
struct DiscCells {
  explicit DiscCells(int across);

  /// How far a line through the disc is from its centre, p.
  struct Distance {
    double square;  ///< p^2
    double half;    ///< sqrt(1 - p^2): half of what the line has of a ball of radius 1
  };
  static Distance distanceOf(Vec2 point);

  /// Those of a list of points, each once.
  struct Distances {
    std::vector<Distance> all;
    std::vector<std::uint32_t> ofPoints;  ///< indices of `all`
  };
  static Distances distancesOf(const std::vector<Vec2>& points);

  std::vector<Vec2> corners;  ///< of the cells, row by row; of those off the disc its nearest point
  Distances cornerDistances;
  Distances
      insideDistances;  ///< of the points where a cell is integrated (kWholeCell), cell by cell
};

/// Answers which fraction of a light a point of a surface sees: all or nothing of a point light,
/// the fraction of its volume of a ball. If a wall runs through a ball, the part that the centre
/// does not see does not shine.
class LightSight {
 public:
  /// `softSamples` to a ball, a square number: its disc, as it is seen, is divided into so many
  /// cells, and shadows' edges cut these exactly where they run straight. Where a ball is cut by
  /// more than planes, or seen from too near, 32 times as many points are spread over it instead.
  /// With 0 it is a point. `solidMaskedMiddles`: see BakeSettings.
  LightSight(const Scene& scene, const LightSource& light, int softSamples,
             bool solidMaskedMiddles = false);
  ~LightSight();
  LightSight(LightSight&&) noexcept;

  /// 0..1. Adds the rays that it took to `rays`, and tells `met`, if any, where they came.
  double seenFraction(const LightTarget& target, std::int64_t& rays,
                      SectorSet* met = nullptr) const;
  /// The same, of one of the targets of a shaft from `shaftLight()`, whose rays have this outcome.
  double seenFraction(const LightTarget& target, const Shaft& shaft, Shaft::Outcome outcome,
                      std::int64_t& rays) const;

  const ShaftLight& shaftLight() const { return shaftLight_; }
  /// From now on the first call of `beams` finds the beam tree of a point light. Balls have none.
  void useBeams(const Scene& scene, double reach, std::size_t mostBytes);
  /// None where they are not used. Any thread may ask.
  const BeamTree* beams() const;
  /// Has them found now, if they are used and no thread has begun: so threads that will need those
  /// of the same lights each find some, instead of waiting for one another.
  void findBeamsUnlessBegun() const;
  /// The sectors that decide which part of the light shines: that of its centre, and all that lines
  /// from there to its other points enter.
  std::span<const SectorId> sectors() const { return sectors_; }

 private:
  template <typename Sees>
  double seenFractionBy(const LightTarget& target, Sees&& sees) const;
  bool isBeforePlanes(Vec3 p) const;
  template <typename Sees>
  double seenOfDisc(const LightTarget& target, Sees&& sees) const;
  template <typename Sees>
  double seenOfPoints(Sees&& sees) const;

  Raytracer raytracer_;
  Raytracer::Source center_;
  double radius_;  ///< metres
  int cells_;      ///< along the disc's diameter
  DiscCells discCells_;
  std::vector<Plane> planes_;  ///< of the walls and flats that come into the ball
  /// Points spread evenly over the ball, without those that its centre does not see; and how many
  /// there are with these.
  std::vector<Raytracer::Source> points_;
  int pointCount_ = 0;
  /// Whether what shines is what lies in front of all planes, if there are any.
  bool isCutByPlanes_ = false;
  ShaftLight shaftLight_;
  struct Beams;
  std::unique_ptr<Beams> beams_;
  std::vector<SectorId> sectors_;
};

/// How points see the lights of a level, in their order.
struct LightSights {
  LightSights(const Scene& scene, const BakeSettings& settings);

  std::vector<LightSight> fine;
  /// With a quarter of the samples to a ball: for points of which the mean is taken.
  std::vector<LightSight> rough;
  /// Metres from which on they are left out, see LightSource::reach.
  std::vector<double> reach;
};

}  // namespace hearth
