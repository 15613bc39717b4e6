#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// Some of `BeamSet::planes`.
struct PlaneRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// A flat portal, seen from the side of the light.
struct BeamHatch {
  double z;
  bool isFloor;
  const Segment* from;  ///< rays reach it beyond this wall, if any
  const Segment* to;    ///< and before this one
};

/// An entry into a sector. Directions lead from the light to the vertices of walls.
struct BeamWindow {
  SectorId sector;
  const Segment* from;
  Vec2 begin;
  Vec2 end;
  PlaneRange planes;
  bool isDoubtful;
  std::optional<BeamHatch> hatch;
};

/// The way of a ray through a sector: the walls at which it enters and leaves.
struct BeamStretch {
  const Segment* from;
  const Segment* to;

  friend bool operator==(BeamStretch, BeamStretch) = default;
};

/// A stretch that is the same in all of a part of a window.
struct VisibleStretch {
  BeamStretch stretch;
  Vec2 begin;
  Vec2 end;
};

/// Sweeps windows from one vertex to the next, and finds what the light sees between them.
class BeamSweep {
 public:
  BeamSweep(const Scene& scene, Vec3 light) : scene_(scene), light_(light) {}

  /// Valid until the next call of `sweep`.
  const std::vector<VisibleStretch>& visible() const { return finished_; }
  /// Directions in which rounding decides which walls rays meet.
  const std::vector<Vec2>& doubtfulDirections() const { return doubtful_; }

  void sweep(const BeamWindow& window);

 private:
  /// The part of a wall that lies in a window, in fractions of a straight line across the window.
  struct Part {
    const Segment* wall;
    bool isEntrance;  ///< seen from its back
    double first;
    double last;
  };

  struct Bound {
    double fraction;
    Vec2 direction;
  };

  struct Crossing {
    double distance;
    const Segment* wall;
    bool isEntrance;
  };

  Vec2 fromLight(Vec2 p) const { return p - light_.xy(); }
  double distanceTo(const Segment& wall, Vec2 direction) const;
  void findParts(const BeamWindow& window);
  void addBound(const BeamWindow& window, Vec2 direction);
  void addPart(const BeamWindow& window, Part part, Vec2 a, Vec2 b);
  void findStretches(const BeamWindow& window, Vec2 direction);
  void findStretchesAcross(const BeamHatch& hatch, Vec2 direction);
  double beyond(const Segment* wall, Vec2 direction) const;
  void goOn(std::size_t last, std::size_t bound, Vec2 end);
  bool endsBetween(BeamStretch stretch, std::size_t last, std::size_t bound) const;

  Scene scene_;
  Vec3 light_;
  std::vector<VisibleStretch> finished_;
  std::vector<Vec2> doubtful_;
  // Of the window at hand:
  std::vector<Part> parts_;
  std::vector<Bound> bounds_;
  std::vector<const Part*> active_;
  std::vector<Crossing> crossings_;
  std::vector<BeamStretch> stretches_;
  std::vector<VisibleStretch> visible_;
  std::vector<VisibleStretch> seen_;
};

}  // namespace hearth
