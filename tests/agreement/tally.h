#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "level/surface.h"

namespace hearth::agreement {

/// How many pixels were compared, and how many of them disagreed.
struct Count {
  std::int64_t tested = 0;
  std::int64_t missed = 0;
  std::int64_t excused = 0;  ///< disagreed, but too near to an edge to be told apart

  Count& operator+=(const Count& other);
};

struct KindTally {
  Count texture;     ///< `--light none`, every pixel, exact
  Count gridLight;   ///< `--light only` against truth at texel centres, within 1 level
  Count exactLight;  ///< `--light only` against truth at the pixel, within 3 levels

  KindTally& operator+=(const KindTally& other);
};

/// Why exact light is not compared at a pixel: the first that holds. The last three can hold for
/// some channels only: then the others are compared.
enum class LeftOut { CoarseTexel, NearLight, InsideMesh, ShadowEdge, CurveJump, Clip, BeyondEdge };
inline constexpr std::size_t kLeftOut = 7;

struct Tally {
  std::array<KindTally, kSurfaceKindCount> kinds;
  std::int64_t levels = 0;
  std::int64_t views = 0;
  std::int64_t holes = 0;                        ///< pixels that no surface covered
  std::array<std::int64_t, kLeftOut> leftOut{};  ///< pixels, by LeftOut
  std::int64_t atJumps = 0;                      ///< excused comparisons at jumps of curves
  std::int64_t asked = 0;                        ///< pixels asked whether they are clear of edges
  std::int64_t clear = 0;                        ///< those of them that are
  std::int64_t lightAsked = 0;                   ///< pixels at which light was to be compared
  std::string firstMiss;                         ///< how to see it

  Tally& operator+=(const Tally& other);
  /// Of all kinds together.
  KindTally sum() const;
  std::int64_t missed() const;
  /// The least number of pixels tested of any kind.
  std::int64_t minTested() const;
};

/// How much of what was drawn is really held against truth: a comparison that excuses every pixel
/// finds no mistake.
struct Fractions {
  double clear = 0;       ///< of the pixels asked
  double gridTested = 0;  ///< of the pixels at which light was to be compared, as the next
  double exactTested = 0;
  double textureExcused = 0;  ///< of all pixels
  double gridExcused = 0;     ///< of the pixels at which light was to be compared, as the next
  double exactExcused = 0;
};
Fractions fractionsOf(const Tally& tally);

/// Bounds for many random levels together, a little off what 20,000 of them gave: 0.960, 0.935 and
/// 0.202, then 0, 0.00014 and 0.000004. Most have texels too coarse for exact light. Few levels
/// have most of the light that is excused, at shadows: the first 2,000 gave 0.00026.
inline constexpr Fractions kRandomLevels = {.clear = 0.95,
                                            .gridTested = 0.92,
                                            .exactTested = 0.17,
                                            .textureExcused = 0.0001,
                                            .gridExcused = 0.0004,
                                            .exactExcused = 0.0001};
/// Bounds for all shots of the tutorial, which found 0.802, 0.920 and 0.802, then 0, 0.0030 and
/// 0.0009.
inline constexpr Fractions kTutorial = {.clear = 0.78,
                                        .gridTested = 0.90,
                                        .exactTested = 0.78,
                                        .textureExcused = 0.0001,
                                        .gridExcused = 0.004,
                                        .exactExcused = 0.0015};

/// In words, each fraction tested that is below its bound, and each excused that is above: empty
/// where all is well.
std::string beyond(const Fractions& bounds, const Fractions& fractions);

/// A line per kind of surface, and one for all.
std::string table(const Tally& tally);

}  // namespace hearth::agreement
