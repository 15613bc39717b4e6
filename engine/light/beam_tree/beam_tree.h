#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "level/scene.h"
#include "light/beam_tree/beam.h"
#include "light/grid/plane.h"
#include "light/sight/light_kernels.h"
#include "light/sight/raytracer.h"

namespace hearth {

/// What a point light sees: one beam for each wall and each chain of openings through which the
/// light sees part of the wall (Heckbert and Hanrahan 1984). Whether a point is lit then takes a
/// few products and no ray: walls are vertical, so vertical planes through the light bound a beam
/// at the sides, and planes through the light and the edges of openings bound it below and above.
///
/// The tree agrees with the ray tracer. It gives no answer near the bounds of a beam, where
/// rounding decides, nor behind a flat portal that a slope reaches.
class BeamTree {
 public:
  /// Finds all beams up to `reach` metres, and may find fewer beyond. Answers nothing if the beams
  /// would take more than about `mostBytes`. Keeps the scene.
  BeamTree(const Scene& scene, const Raytracer::Source& light, double reach, std::size_t mostBytes);

  /// Points, as they are seen from the light: all that lie between some corners.
  struct Points {
    std::span<const Vec3> corners;
    CornerOffsets directions;
    double reach = 0;   ///< metres, at least those to the farthest
    double noise = 0;   ///< metres by which rounding moves a crossing at the most
    double margin = 0;  ///< metres from the bounds of a beam within which nothing is said
  };
  /// One to eight corners, which must outlive what they are made into.
  Points seen(std::span<const Vec3> corners) const;

  /// Whether it says anything of points on a plane that bounds the air of a sector. It does not
  /// where they, or the light, are so near to a plane of its that rounding could stop rays there.
  bool knows(SectorId sector, const Plane& plane, const Points& points) const;

  /// A beam that may hold points, and which of its bounds may part them: see findParting().
  struct Doubt {
    const Beam* beam;
    std::uint32_t parting;

    bool atBegin() const { return (parting & kAtBegin) != 0; }
    bool atEnd() const { return (parting & kAtEnd) != 0; }
    bool elsewhere() const { return beam->isDoubtful || (parting & ~(kAtBegin | kAtEnd)) != 0; }
  };
  using Found = std::vector<Doubt>;
  /// Whether the points, which lie in the air of `sector`, and `on` a wall of it if that is given,
  /// are lit: one beam holds all of them, or a row of beams does. If not, all beams that hold some
  /// of them, perhaps, are added to `found`: if there are none, the points are dark.
  bool find(SectorId sector, const Segment* on, const Points& points, Found& found) const;
  /// The same of points among those before; `found` has the beams for these from `first` to `last`.
  bool narrow(const Points& points, const Segment* on, Found& found, std::size_t first,
              std::size_t last) const;

  /// Rows of samples.
  struct Samples {
    SampleArrays arrays;
    std::size_t columns;
    std::size_t rows;
    std::size_t stride;  ///< from a row to the next
  };
  /// Memory of findSeen(), to be kept from call to call.
  struct Parting {
    std::vector<BoundingPlane> bounds;
    std::vector<PartingBounds> beams;
  };
  /// What is seen by each of some samples among `points`, by the same beams: kUnknownFraction where
  /// only narrow() can tell.
  void findSeen(const Points& points, const Segment* on, std::span<const Doubt> doubts,
                const Samples& samples, Parting& parting, double* seen) const;

 private:
  /// The first two bounds of a beam.
  static constexpr std::uint32_t kAtBegin = 1;
  static constexpr std::uint32_t kAtEnd = 2;

  BeamBounds boundsOf(const Beam& beam, const Segment* on) const;
  bool comesToEndOf(const Segment& wall, const Points& points) const;
  static bool isRow(std::span<const Doubt> doubts);
  bool add(const Beam& beam, const Points& points, const Segment* on, std::uint32_t asked,
           Found& found) const;
  /// Some of the beams, by index.
  struct Range {
    std::size_t first;
    std::size_t last;
  };
  bool addSpanning(Range beams, const Points& points, const Segment* on, Found& found) const;

  Scene scene_;
  Raytracer::Source light_;
  BeamSet found_;
  /// By beam: its first two bounds, for many beams at once.
  struct Sides {
    std::vector<double> beginX;
    std::vector<double> beginY;
    std::vector<double> endX;
    std::vector<double> endY;
  } sides_;
  std::unordered_map<std::uint32_t, Range> rangeOf_;  ///< of a sector
};

}  // namespace hearth
