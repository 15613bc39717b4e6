#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "level/level.h"
#include "light/plane.h"
#include "light/raytracer.h"

namespace hearth {

/// What a cone is bounded by above or below: the plane through the light and a straight edge of an
/// opening.
struct HeightPlane {
  Vec2 gradient;         ///< metres of height for each metre from the light, along x and y
  bool isBelow;          ///< whether the cone lies above it
  double slackPerMetre;  ///< by which rounding may move it, metres for each metre from the light
};

/// What a light sees of a sector through a row of openings, up to one wall of it. All of its bounds
/// are planes, most of them through the light; lines on the map are given as directions of length 1
/// from there.
struct LightCone {
  SectorId sector;
  const Segment* from;  ///< beyond this wall; null where none is before it
  const Segment* to;    ///< up to this one
  Vec2 begin;           ///< it lies clockwise of this, as seen on the map,
  Vec2 end;             ///< and not of this; less than 180 degrees
  Vec2 beginsAt;        ///< from the light to the vertices that say so
  Vec2 endsAt;
  std::uint32_t firstPlane;
  std::uint32_t lastPlane;
  /// Whether it may be dark in there: behind textures with holes, and where a cone is so narrow
  /// that rounding decides what it meets (`begin` is `end` then).
  bool isDoubtful;
};

/// What a point of light sees: one cone for each wall and each row of openings through which it
/// sees some of that. Whether a point is lit, then, takes a few products, and no ray: a level is
/// flat on the map, so walls bound light by upright planes, and the heights of openings bound it by
/// planes that lean on the light.
///
/// What it says holds for rays, as the ray tracer would say: near the bounds of cones, where
/// rounding decides, it says nothing. Nor does it of what lies behind flat portals that are slopes,
/// too.
class LightCones {
 public:
  /// Of what is no farther than `reach` metres; farther away it may find less.
  /// Keeps a reference to the level.
  LightCones(const Level& level, const Raytracer::Source& light, double reach);

  /// Points, as they are seen from the light: all that lie between some corners.
  struct Points {
    std::array<Vec3, 8> ways;  ///< to the corners
    std::size_t count = 0;
    double reach = 0;   ///< metres, at least those to the farthest
    double noise = 0;   ///< metres by which rounding moves a crossing at the most
    double margin = 0;  ///< metres from the bounds of a cone within which nothing is said
  };
  /// One to eight corners.
  Points seen(std::span<const Vec3> corners) const;

  /// Whether it says anything of points on a plane that bounds the air of a sector. It does not
  /// where they, or the light, are so near to a plane of its that rounding could stop rays there.
  bool knows(SectorId sector, const Plane& plane, const Points& points) const;

  /// A cone that may hold points, and which of its bounds may part them: its begin, its end,
  /// others.
  struct Doubt {
    const LightCone* cone;
    bool atBegin = false;
    bool atEnd = false;
    bool elsewhere = false;
  };
  using Found = std::vector<Doubt>;
  /// Whether one cone holds all the points, or such as begin where another ends, which lie in the
  /// air of `sector`, and `on` a wall of it, if that is given. If not, all that hold some of them,
  /// perhaps, are added to `found`: if there are none, the points are dark.
  bool find(SectorId sector, const Segment* on, const Points& points, Found& found) const;
  /// The same of points among those before; `found` has the cones for these from `first` to `last`.
  bool narrow(const Points& points, const Segment* on, Found& found, std::size_t first,
              std::size_t last) const;

 private:
  class Finder;
  std::span<const HeightPlane> planesOf(const LightCone& cone) const {
    return std::span(planes_).subspan(cone.firstPlane, cone.lastPlane - cone.firstPlane);
  }
  double leastInFront(const Points& points) const;
  bool comesToEndOf(const Segment& wall, const Points& points) const;
  bool areClear(const Sector& sector, const Points& points) const;
  std::optional<Doubt> doubtOf(const LightCone& cone, const Points& points,
                               const Segment* on) const;
  static bool isRow(std::span<const Doubt> doubts);
  bool add(const LightCone& cone, const Points& points, const Segment* on, Found& found) const;

  const Level& level_;
  Raytracer::Source light_;
  std::vector<LightCone> cones_;  ///< by sectors
  struct Range {
    std::size_t first;
    std::size_t count;
  };
  std::unordered_map<std::uint32_t, Range> rangeOf_;  ///< in `cones_`, of a sector
  std::vector<HeightPlane> planes_;
  std::unordered_set<std::uint32_t> unknown_;  ///< sectors
  bool isComplete_ = false;
};

}  // namespace hearth
