#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/beam_tree/beam.h"
#include "light/beam_tree/beam_kernels.h"
#include "light/beam_tree/beam_tree_builder.h"
#include "light/grid/plane.h"
#include "light/rays/raytracer.h"

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
  /// Gives no answers if the beams would take more than the limit, nor outside their region. Keeps
  /// the scene.
  BeamTree(const Scene& scene, const Raytracer::Source& light, const BeamLimits& limits);

  /// All points between some corners, as seen from the light.
  struct Points {
    std::span<const Vec3> corners;
    CornerOffsets directions;
    double reach = 0;   ///< metres, at least to the farthest
    double noise = 0;   ///< metres by which rounding moves a crossing at the most
    double margin = 0;  ///< metres from the bounds of a beam within which there is no answer
  };
  /// Of one to eight corners, which must outlive the result.
  Points pointsBetween(std::span<const Vec3> corners) const;

  /// Whether it gives answers for points on a plane that bounds the air of a sector. It gives none
  /// if they, or the light, are so near to a floor or ceiling that rounding could stop rays there.
  bool knows(SectorId sector, const Plane& plane, const Points& points) const;

  /// A beam that may contain points, and which of its bounds may part them: see findStraddled().
  struct CandidateBeam {
    const Beam* beam;
    std::uint32_t straddled;

    bool atBegin() const { return (straddled & kAtBegin) != 0; }
    bool atEnd() const { return (straddled & kAtEnd) != 0; }
    bool elsewhere() const { return beam->isDoubtful || (straddled & ~(kAtBegin | kAtEnd)) != 0; }
  };
  using Candidates = std::vector<CandidateBeam>;
  /// Whether the points are lit: one beam contains all of them, or a row of beams does. They lie in
  /// the air of `sector`, and `on` a wall of it if that is given. If not, all beams that may
  /// contain some of them are added to `candidates`; if there are none, the points are dark.
  bool find(SectorId sector, const Segment* on, const Points& points, Candidates& candidates) const;
  /// The same for some of the points of an earlier call, whose beams are `candidates` from `first`
  /// to `last`.
  bool narrow(const Points& points, const Segment* on, Candidates& candidates, std::size_t first,
              std::size_t last) const;

  /// Memory of findSeen(); keep it from call to call.
  struct Scratch {
    std::vector<BoundingPlane> bounds;
    std::vector<StraddledBounds> beams;
  };
  /// Which fraction each of some samples among `points` sees, by the same beams: kUnknownFraction
  /// if only narrow() can decide. Of `samples` and `seen`, see BeamKernels::findSeen.
  void findSeen(const Points& points, const Segment* on, std::span<const CandidateBeam> candidates,
                const SampleArrays& samples, std::size_t count, Scratch& scratch,
                double* seen) const;

 private:
  /// The first two bounds of a beam.
  static constexpr std::uint32_t kAtBegin = 1;
  static constexpr std::uint32_t kAtEnd = 2;

  BeamBounds boundsOf(const Beam& beam, const Segment* on) const;
  bool isInRegion(const Points& points) const;
  bool comesToEndOf(const Segment& wall, const Points& points) const;
  static bool isRow(std::span<const CandidateBeam> candidates);
  bool add(const Beam& beam, const Points& points, const Segment* on, std::uint32_t asked,
           std::uint32_t known, Candidates& candidates) const;
  /// Some of the beams, by index.
  struct Range {
    std::size_t first;
    std::size_t last;
  };
  struct BeamsOfSector {
    SectorId sector;
    Range all;
    Range withoutWall;  ///< doubtful ones, which come first; the others follow by their walls
  };
  Range upTo(const Segment& wall, Range beams) const;
  bool addSpanning(Range beams, const Points& points, const Segment* on,
                   Candidates& candidates) const;

  Scene scene_;
  Raytracer::Source light_;
  std::optional<Box> region_;
  BeamSet found_;
  /// By beam: its first two bounds, for many beams at once.
  struct Sides {
    std::vector<double> beginX;
    std::vector<double> beginY;
    std::vector<double> endX;
    std::vector<double> endY;
  } sides_;
  std::vector<const Segment*> walls_;    ///< by beam: up to which it goes
  std::vector<BeamsOfSector> bySector_;  ///< of those that have some, in rising order
};

}  // namespace hearth
