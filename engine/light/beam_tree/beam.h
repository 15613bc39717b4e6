#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "level/level.h"

namespace hearth {

/// The plane through the light and a straight edge of an opening, which bounds a beam above or
/// below.
struct HeightPlane {
  Vec2 gradient;         ///< metres of height for each metre from the light, along x and y
  bool isBelow;          ///< whether the beam lies above it
  double slackPerMetre;  ///< by which rounding may move it, metres for each metre from the light
};

/// The part of a sector that a light sees through a row of openings, up to one wall. All bounds are
/// planes, most of them through the light. Lines in plan are directions of length 1 from there.
struct Beam {
  SectorId sector;
  const Segment* from;  ///< beyond this wall; null where none is before it
  const Segment* to;    ///< up to this one
  Vec2 begin;           ///< it lies clockwise of this, as seen in plan,
  Vec2 end;             ///< and not of this; less than 180 degrees
  Vec2 beginsAt;        ///< from the light to the vertices of these
  Vec2 endsAt;
  std::uint32_t firstPlane;
  std::uint32_t lastPlane;
  /// Whether points in it may be dark: behind textures with holes, and if a beam is so narrow that
  /// rounding decides what it meets (then `begin` is `end`).
  bool isDoubtful;
};

/// A plane that bounds a beam, in coordinates relative to the light: a vector v is in front of it
/// by dot(normal, v) - offset. For points at most `reach` metres away rounding decides within
/// margin * perMargin + reach * perMetre of the plane, with the margin of rays to them.
struct BeamBound {
  Vec3 normal;
  double offset;
  double perMargin;
  double perMetre;

  double slack(double margin, double reach) const { return margin * perMargin + reach * perMetre; }
};

/// The bounds of a beam, for directions from the light to points: begin, end and planes, then the
/// walls between which the beam lies. For points `on` the last of these walls, the walls are left
/// out. A bound is computed when it is needed: that takes no longer than to read it from memory,
/// and storing all of them would take much.
class BeamBounds {
 public:
  BeamBounds(const Beam& beam, std::span<const HeightPlane> planes, Vec3 light, const Segment* on)
      : beam_(beam), planes_(planes), light_(light.xy()) {
    if (on && beam.to == on) return;
    for (const Segment* wall : {beam.from, beam.to})
      if (wall) walls_[wallCount_++] = wall;
  }

  std::size_t size() const { return kSides + planes_.size() + wallCount_; }
  BeamBound operator[](std::size_t index) const {
    if (index == 0) return ofSide({-beam_.begin.y, beam_.begin.x});
    if (index == 1) return ofSide({beam_.end.y, -beam_.end.x});
    if (index - kSides < planes_.size()) return of(planes_[index - kSides]);
    return of(*walls_[index - kSides - planes_.size()]);
  }

 private:
  static constexpr std::size_t kSides = 2;

  static BeamBound ofSide(Vec2 inward) { return {{inward.x, inward.y, 0}, 0, 1, 0}; }
  static BeamBound of(const HeightPlane& plane) {
    const double sign = plane.isBelow ? 1 : -1;
    return {{-sign * plane.gradient.x, -sign * plane.gradient.y, sign}, 0, 1, plane.slackPerMetre};
  }
  BeamBound of(const Segment& wall) const {
    const Vec2 along = wall.p1 - wall.p0;
    return {{-along.y, along.x, 0}, cross(along, wall.p0 - light_), wall.length, 0};
  }

  const Beam& beam_;
  std::span<const HeightPlane> planes_;
  Vec2 light_;
  std::array<const Segment*, 2> walls_{};
  std::size_t wallCount_ = 0;
};

/// All beams of a light.
struct BeamSet {
  std::vector<Beam> beams;
  std::vector<HeightPlane> planes;
  /// Sectors that light may come to in ways that no beam describes.
  std::unordered_set<std::uint32_t> unknown;
  /// False if the search stopped at its limit.
  bool isComplete = false;

  std::span<const HeightPlane> planesOf(const Beam& beam) const {
    return std::span(planes).subspan(beam.firstPlane, beam.lastPlane - beam.firstPlane);
  }
  /// With what BeamTree keeps of each: its sides, and its last wall.
  std::size_t bytes() const {
    return beams.size() * (sizeof(Beam) + 4 * sizeof(double) + sizeof(const Segment*)) +
           planes.size() * sizeof(HeightPlane);
  }
};

}  // namespace hearth
