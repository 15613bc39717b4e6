#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"
#include "math/box.h"
#include "math/line_part.h"

namespace hearth {

/// What a thing covers of the map: a convex polygon, or a line.
class PlanShape {
 public:
  static constexpr std::size_t kMaxCorners = 8;

  /// Of its corners in order around it, at least one and at most kMaxCorners. Where all of them are
  /// within kPositionSlack of one line, it is that line.
  explicit PlanShape(std::span<const Vec2> corners);

  bool mayTouch(const Sector& sector) const;

  /// The part of a segment that it covers, or touches.
  std::optional<LinePart> partOf(const Segment& segment) const;

  /// Whether it covers or touches what two sectors have in common, a common edge apart. Uses `cuts`
  /// as memory.
  bool meetsBoth(const Level& level, const Sector& a, const Sector& b,
                 std::vector<double>& cuts) const;

 private:
  /// A line on whose one side it lies.
  struct Side {
    Vec2 from;
    Vec2 inward;  ///< of length 1

    double distance(Vec2 p) const { return dot(p - from, inward); }
  };
  struct Border {
    Vec2 from;
    Vec2 to;
  };

  void makeLine(Vec2 from, Vec2 to);
  void makePolygon(std::span<const Vec2> corners);
  void addSide(Vec2 from, Vec2 inward) { sides_[sideCount_++] = {from, inward}; }
  void addBorder(Vec2 from, Vec2 to) { borders_[borderCount_++] = {from, to}; }
  std::span<const Side> sides() const { return {sides_.data(), sideCount_}; }
  std::span<const Border> borders() const { return {borders_.data(), borderCount_}; }
  bool covers(Vec2 p, double slack) const;
  bool touchesCorner(const Level& level, const Sector& a, const Sector& b) const;
  bool hasPointBeside(const Level& level, const Sector& a, const Sector& b, Border line,
                      std::vector<double>& cuts) const;

  Box box_;
  std::array<Side, kMaxCorners> sides_;
  std::size_t sideCount_ = 0;
  std::array<Border, kMaxCorners> borders_;
  std::size_t borderCount_ = 0;
};

}  // namespace hearth
