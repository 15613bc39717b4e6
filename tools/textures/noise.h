#pragma once

#include <cstdint>

namespace hearth::textures {

/// A number that looks random and depends on nothing but its arguments.
std::uint32_t hash(int x, int y, std::uint32_t seed);

/// The same as a number in [0, range).
int pick(int x, int y, std::uint32_t seed, int range);

/// The remainder in [0, n), for negative `a` too.
constexpr int wrap(int a, int n) { return (a % n + n) % n; }

/// How a noise repeats: every `width` by `height` pixels, with features of `cellX` by `cellY`
/// pixels. The cells must divide the size.
struct Grain {
  int width;
  int height;
  int cellX;
  int cellY;
};

/// Smooth noise in [-128, 127]: random values at the corners of the cells, eased in between.
int smoothNoise(int x, int y, Grain grain, std::uint32_t seed);

/// Smooth noise with two finer octaves of half the strength each, in about [-128, 127]. The cells
/// must be multiples of four.
int cloudNoise(int x, int y, Grain grain, std::uint32_t seed);

}  // namespace hearth::textures
