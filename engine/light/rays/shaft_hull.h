#pragma once

#include <array>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "level/level.h"
#include "math/box3.h"
#include "math/vec.h"

namespace hearth {

/// A box that contains the ends of rays.
struct TargetBox {
  std::array<Vec3, 8> storage;  ///< corners
  std::size_t count = 0;        ///< of them: 4 if the box is flat
  Vec3 normal;                  ///< unit, of the surface, into the air

  /// Nothing is known of surfaces in it.
  static TargetBox around(const Box3& box);
  static TargetBox ofPoint(Vec3 point, Vec3 normal) { return {{point}, 1, normal}; }
  std::span<const Vec3> corners() const { return {storage.data(), count}; }
};

/// Cosine. A plane steeper than this bounds no heights: they would be far off, by rounding too.
inline constexpr double kSteepest = 1e-3;

/// Where rays towards a sun go: to all points of its disc, a cone of directions.
struct SunCone {
  Vec3 direction;        ///< unit, towards its middle
  double sinRadius = 0;  ///< of the angle to its rim, less than 90 degrees
  double cosRadius = 1;
  double reach = 0;     ///< metres: no ray goes as far in the level
  double zHighest = 0;  ///< of its air

  bool goesUp() const { return direction.z > sinRadius; }
  /// Whether some ray rises nearly straight up: it may end at a flat before it crosses a wall.
  bool isUpright() const { return length(direction.xy()) <= sinRadius + kSteepest; }
};

/// Heights above the two ends of a part of a wall, with a straight line between them.
struct EndHeights {
  double from;
  double to;
};

/// A convex body that contains all rays between a ball or point light, or a sun, and a box of
/// targets, and everything less than `margin` away from them. Upright planes bound it at the sides,
/// which are lines in plan, and sloped planes bound it above and below.
///
/// A half-space whose border touches the ball and the box contains their hull, whatever its
/// direction. So directions may be chosen to fit well, and only the distance of each plane must be
/// exact.
class ShaftHull {
 public:
  template <typename Item, std::size_t N>
  struct Few {
    std::array<Item, N> items;
    std::size_t count = 0;
    void add(const Item& item) { items[count++] = item; }
    const Item& operator[](std::size_t i) const { return items[i]; }
    std::span<const Item> all() const { return {items.data(), count}; }
  };

  ShaftHull(Vec3 center, double radius, const TargetBox& targets);
  ShaftHull(const SunCone& sun, const TargetBox& targets);

  /// The part of a wall that the body meets.
  class Slice {
   public:
    double from;  ///< fractions of the way from p0 to p1
    double to;
    /// Whether all of it is below (above) a line.
    bool isBelow(EndHeights line) const;
    bool isAbove(EndHeights line) const;

   private:
    friend class ShaftHull;
    static constexpr std::size_t kMaxBounds = 4;
    std::array<EndHeights, kMaxBounds> tops_;
    std::array<EndHeights, kMaxBounds> bottoms_;
    std::size_t topCount_ = 0;
    std::size_t bottomCount_ = 0;
  };
  std::optional<Slice> slice(Vec2 p0, Vec2 p1) const;

  /// The convex outline on the map of what the body has in a box, or of somewhat more.
  using Outline = Few<Vec2, 16>;
  Outline outlineIn(const Box& box) const;

  /// Calls `visit(wall)` for the walls of a sector that the body may meet, and for others. `near`
  /// is room for their indices.
  template <typename Visit>
  void forEachWallNear(const Level& level, const Sector& sector,
                       std::pmr::vector<std::uint32_t>& near, Visit&& visit) const {
    const std::span<const Segment> walls = level.segmentsOf(sector);
    const WallGrid* const grid = level.wallGridOf(sector);
    if (!grid) {
      for (const Segment& wall : walls) visit(wall);
      return;
    }
    near.clear();
    const Outline outline = outlineIn(grown(grid->box(), grid->metresPerCell()));
    grid->addUnder(outline.all(), near);
    for (const std::uint32_t i : near) visit(walls[i]);
  }

  /// Distances from a line of the map, positive in front of it: along its unit normal. (Those of
  /// the light are for one with a place.)
  struct Distances {
    double minOfLight;
    double maxOfLight;
    double minOfTargets;
    double maxOfTargets;
  };
  Distances distances(Vec2 onLine, Vec2 normal) const;

  /// Whether the body may have something of a mesh that casts a shadow.
  bool mayMeet(const Level& level, std::uint32_t mesh) const;
  /// Whether `test(face)`, of an index, holds for one of the mesh's faces of which it may have
  /// something. No more is tested once one does.
  template <typename Test>
  bool anyFaceMet(const Level& level, std::uint32_t mesh, Test&& test) const {
    const std::span<const MeshFace> faces = level.facesOf(level.meshes[mesh]);
    return level.faceTrees[mesh].anyFace(
        [this](const Box3& box) { return !isClearOf(box); },
        [&](std::uint32_t face) { return !isClearOf(faces[face]) && test(face); });
  }

  /// Metres. More than rays come off their course by rounding, and than kArrival: what is outside
  /// has no part in whether a ray arrives.
  double margin() const { return margin_; }
  /// Metres by which rounding moves a target or a crossing at the most.
  double noise() const { return noise_; }
  /// Of the longest ray.
  double reach() const { return reach_; }
  double zMin() const { return center_.z + lows_[0].atCenter; }
  double zMax() const { return center_.z + highs_[0].atCenter; }

 private:
  /// The map's side of an upright plane: what p has dot(normal, p) <= most.
  struct HalfPlane {
    Vec2 normal;
    double most;
  };
  struct SlopedPlane {
    Vec2 gradient;
    double atCenter;
    double at(Vec2 p) const { return atCenter + dot(gradient, p); }
  };
  static Outline clipped(const Outline& outline, const HalfPlane& side);
  bool isClearOf(const Box3& box) const;
  bool isClearOf(const MeshFace& face) const;
  template <typename IsBeyond>
  bool anyPlane(IsBeyond&& isBeyond) const;
  void addPlane(Vec3 normal);
  void addAround(Vec2 axis);
  void addAroundZenith(const SunCone& sun, double lowestTarget);
  void addAroundSun(const SunCone& sun);
  void addAboveAndBelow(Vec2 along);
  double farthest(Vec3 normal) const;
  std::span<const Vec3> targets() const { return {targets_.data(), count_}; }

  // All but `center_` relative to it.
  Vec3 center_;  ///< of the light; towards a sun, one of the targets
  double radius_;
  std::array<Vec3, 8> targets_;
  std::size_t count_;
  double margin_ = 0;
  double noise_ = 0;
  double reach_ = 0;
  Few<HalfPlane, 6> sides_;
  Few<SlopedPlane, Slice::kMaxBounds> highs_;
  Few<SlopedPlane, Slice::kMaxBounds> lows_;
};

}  // namespace hearth
