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
enum class LeftOut { CoarseTexel, NearLight, ShadowEdge, CurveJump, Clip, BeyondEdge };
inline constexpr std::size_t kLeftOut = 6;

struct Tally {
  std::array<KindTally, kSurfaceKinds> kinds;
  std::int64_t levels = 0;
  std::int64_t views = 0;
  std::int64_t holes = 0;                        ///< pixels that no surface covered
  std::array<std::int64_t, kLeftOut> leftOut{};  ///< pixels, by LeftOut
  std::int64_t atJumps = 0;                      ///< excused comparisons at jumps of curves
  std::string firstMiss;                         ///< how to see it

  Tally& operator+=(const Tally& other);
  /// Of all kinds together.
  KindTally sum() const;
  std::int64_t missed() const;
  /// The least number of pixels tested of any kind.
  std::int64_t leastTested() const;
};

/// A line per kind of surface, and one for all.
std::string table(const Tally& tally);

}  // namespace hearth::agreement
