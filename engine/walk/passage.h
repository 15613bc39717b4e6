#pragma once

#include <memory_resource>
#include <optional>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// Of a segment, as fractions of the way from its p0 (0) to its p1 (1); empty unless low < high.
struct Interval {
  double low;
  double high;
  bool isEmpty() const { return !(low < high); }
};

Interval common(Interval a, Interval b);

/// The part of a segment within `radius` of the origin, its ends being given relative to that.
Interval chordOf(Vec2 a, Vec2 b, double radius);

/// The heights that a body takes up, and to which it may step.
struct UprightBody {
  double zFeet;
  double zClimb;  ///< the highest that the feet may step up to, >= zFeet
  double height;
  double zHead() const { return zFeet + height; }
};

/// Openings of a segment, one above the other, that a body can pass as one. Heights are absolute,
/// at p0 and p1; of several lines the highest bottom (the lowest top) counts.
class Passage {
 public:
  /// The pieces [first, last] of a segment.
  Passage(const Scene& scene, const Segment& segment, std::size_t first, std::size_t last);

  /// Where along the segment the body fits through; it steps up if it must.
  Interval openTo(const UprightBody& body) const;

  /// The highest bottom and the lowest top within an interval of the segment; infinite where the
  /// opening goes on through a flat portal of the sector.
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
