#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "light/bakery.h"
#include "truth/trace.h"

namespace hearth {

/// Why a point of a surface gets as much of a light as it does.
enum class LightReason : std::uint8_t {
  Lights,
  TooWeak,      ///< at this distance, whether or not anything stands between
  OutsideSpot,  ///< its spot shines elsewhere
  FacesAway,    ///< it is behind the plane of the surface
  InPlane,      ///< it lies in that plane
  Blocked,      ///< something stands between
  NotReached,   ///< its light passes the place in another part of the level
  NoneSeen,     ///< no straight way leads from here to the sky, or to surfaces that shine
};

/// One light, at a point of a surface.
struct LightFinding {
  std::size_t light;  ///< its index in the level, and in its file
  LightReason reason;
  double distance;          ///< metres, from its middle; of what has no place infinity
  double level;             ///< at that distance, before colour
  double unshaded;          ///< levels, if nothing stood between; white
  double seenFraction = 0;  ///< of a ball, disc or area, 0..1; of a point 0 or 1
  Vec3 adds = {};           ///< levels of red, green and blue
  std::optional<TruthHit> blocker = std::nullopt;  ///< what stands between, if that is the reason
  /// For a blocked light that is near: by how many metres it must be raised (lowered if negative)
  /// to be seen. None if neither helps.
  std::optional<double> lift = std::nullopt;
  /// Whether its light reaches the place or surfaces that the place sees. Else it shines elsewhere,
  /// or gives too little.
  bool comesNear = false;
};

/// The lightmap at a point.
struct LightmapFinding {
  int column;  ///< of the texel, from 0
  int row;
  int columns;
  int rows;
  double metres;  ///< a texel's side
  Vec3 texel;     ///< its levels of red, green and blue; 0 where no light reaches the surface
  Vec3 shown;     ///< mixed with those of the texels around it, as the picture has it
};

/// A point of a surface, and where its light comes from.
struct Inspection {
  TruthHit place;
  std::optional<LightmapFinding> lightmap;  ///< none for skies
  /// None for skies. Lights that give most come first. Of those that give nothing, near ones come
  /// first, and then those that are brightest at their distance.
  std::vector<LightFinding> lights;
  std::size_t notFollowed = 0;  ///< lights that are not among them, being weaker and too many
  Vec3 sum;                     ///< of what they add: levels at this very point, as defined
  /// Levels of light that bounces, about: those of the lightmap beyond the sum. At least, where the
  /// lightmap is at its brightest.
  Vec3 bounced;
};

/// Points that a ball of light is for this.
inline constexpr int kInspectedBallPoints = 128;

/// Levels. A light that adds less to each channel is too weak.
inline constexpr double kVisibleLevel = 1;

/// Follows the lights of the level to a place, with the settings of its bake. With many lights that
/// takes up to some tens of milliseconds.
Inspection inspect(const Scene& scene, const BakedLight& light, const BakeSettings& settings,
                   const TruthHit& place);

}  // namespace hearth
