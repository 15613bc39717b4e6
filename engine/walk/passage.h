#pragma once

#include <memory_resource>
#include <optional>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// A part of a segment: 0 is its p0, 1 its p1. Empty unless low < high.
struct Interval {
  double low;
  double high;
  bool isEmpty() const { return !(low < high); }
};

Interval intersection(Interval a, Interval b);

/// The part of a segment from a to b within `radius` of the origin.
Interval chordOf(Vec2 a, Vec2 b, double radius);

/// The heights that a body takes up, and to which it may step.
struct UprightBody {
  double zFeet;
  double zClimb;  ///< the highest that the feet may step up to, >= zFeet
  double height;
  double zHead() const { return zFeet + height; }
};

/// Openings of a segment, one above the other, that a body can pass as one. Three lines bound it
/// from below and three from above, given by their absolute heights at p0 and p1: the highest
/// bottom and the lowest top count.
class Passage {
 public:
  /// The pieces [first, last] of a segment.
  Passage(const Scene& scene, const Segment& segment, std::size_t first, std::size_t last);

  /// Where along the segment the body fits through; it steps up if it must.
  Interval openTo(const UprightBody& body) const;

  /// The highest bottom and the lowest top within an interval of the segment; infinite if a flat
  /// portal of the sector continues the opening.
  double zBottom(Interval within) const;
  double zTop(Interval within) const;

  std::size_t first() const { return first_; }
  std::size_t last() const { return last_; }

 private:
  struct Line {
    double at0;
    double at1;
  };

  /// The sector's edge, that of the opening and that of the sector behind it.
  struct Lines {
    Line lines[3];
  };

  std::size_t first_;
  std::size_t last_;
  Lines bottoms_;
  Lines tops_;
};

/// All passages of a segment, bottom to top, appended to `passages`.
void findPassages(const Scene& scene, const Segment& segment, std::pmr::vector<Passage>& passages);

}  // namespace hearth
