#pragma once

#include <cstdint>

#include "changes.h"
#include "image/compare.h"
#include "lit_level.h"

/// What must hold of every level, whichever it is: each fails the running test where a change that
/// means nothing shows in a picture.
namespace hearth::extremes {

/// Other names of sectors.
void expectNamesMeanNothing(std::uint64_t seed);

/// Walls cut in two where nothing is.
void expectCutsMeanNothing(std::uint64_t seed);

/// Any number of threads, baking and drawing.
void expectThreadsMeanNothing(std::uint64_t seed);

/// Moved by whole metres: up to 2^20 of them not a byte changes, unless rounding decides.
void expectPlaceMeansNothing(std::uint64_t seed, double metres);

/// Pixels of a level's shots whose light is more than two levels apart, and all pixels.
struct LightDifference {
  std::int64_t over2 = 0;
  std::int64_t pixels = 0;

  LightDifference& operator+=(const LightDifference& other) {
    over2 += other.over2;
    pixels += other.pixels;
    return *this;
  }
};

/// Sectors and lights in another order. Not a texture changes; light may where a sample is equally
/// near to two surfaces that go on from its own: it takes that of the first in the level.
LightDifference expectOrderMeansLittle(std::uint64_t seed);

/// ... and farther out, up to 9 * 10^6 m, textures only change on their edges. Returns how light
/// does.
LightDifference expectDistanceMeansLittle(std::uint64_t seed, double metres);

/// Whether the level of a seed has light of the sky.
bool hasLightOfSky(std::uint64_t seed);

/// Of a thousandth of its size a level shows the same but on edges. Returns how light changes.
LightDifference expectSmallnessMeansLittle(std::uint64_t seed);

/// ... and of a thousand times its size, with the same light too. False when the level is not the
/// same so large: what authors' noise joins comes apart.
bool expectLargenessMeansNothing(std::uint64_t seed);

/// Turned about the origin, and in a mirror: the same surfaces show, except in pixels on edges,
/// and the light is right by the reference.
void expectDirectionMeansNothing(std::uint64_t seed, double degrees);
void expectHandednessMeansNothing(std::uint64_t seed);

/// Slopes, stacks, skies, coloured lights and curves in a sealed sector that nobody sees.
void expectUnseenSectorMeansNothing(std::uint64_t seed);

}  // namespace hearth::extremes
