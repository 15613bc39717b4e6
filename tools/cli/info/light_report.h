#pragma once

#include <array>
#include <cstdint>

#include "level/scene.h"
#include "light/bakery.h"

namespace hearth {

/// Surfaces, and the cost of their light. The first five counts add up to all surfaces.
struct SurfaceReport {
  std::int64_t bare = 0;       ///< no lightmap: sky, or none of it bounds air
  std::int64_t unfaced = 0;    ///< no lightmap: no light within reach is in front of it
  std::int64_t unreached = 0;  ///< no lightmap: there are such lights, but no light arrives
  std::int64_t white = 0;      ///< lightmaps of one channel
  std::int64_t colored = 0;    ///< lightmaps of three
  std::int64_t even = 0;       ///< of both: all texels are the same, and one is kept
  std::int64_t whiteTexels = 0;
  std::int64_t coloredTexels = 0;
  std::int64_t skippedTexels = 0;  ///< of surfaces without a lightmap
  std::int64_t bytes = 0;          ///< of lightmaps, as they are kept
  std::int64_t rays = 0;

  std::int64_t surfaces() const { return bare + unfaced + unreached + white + colored; }
  /// Of lightmaps that are even, not kept.
  std::int64_t sparedBytes() const { return whiteTexels + 3 * coloredTexels - bytes; }
  SurfaceReport& operator+=(const SurfaceReport& other);
};

/// Lights of a kind, and their cost.
struct LightKindReport {
  std::int64_t lights = 0;
  std::int64_t samples = 0;  ///< that were tested against such a light
  std::int64_t rays = 0;

  double raysPerSample() const;  ///< 0 without samples
};

/// Which of a level's light was baked, which was left out, and why.
struct LightReport {
  std::array<SurfaceReport, kSurfaceKindCount> kinds{};  ///< by SurfaceKind
  SurfaceReport all;
  LightKindReport points;
  LightKindReport spheres;
  LightKindReport suns;
  LightKindReport skies;     ///< one, or none; its rays are slices
  LightKindReport emitters;  ///< likewise
  LightKindReport bounced;   ///< likewise, beyond the slices that find skies and emitters as well
  std::int64_t coloredLights = 0;
  std::int64_t uselessLights = 0;  ///< that give no light, or that nothing sees
};

LightReport lightReport(const Scene& scene, const BakedLight& light);

}  // namespace hearth
