#pragma once

#include <cstdint>

namespace hearth {

/// 0..1, evenly, of three numbers: splitmix64 of them.
inline double evenly(int x, int y, int which) {
  std::uint64_t bits = static_cast<std::uint64_t>(x + 100'000) * 1'000'003U +
                       static_cast<std::uint64_t>(y + 100'000) * 7U +
                       static_cast<std::uint64_t>(which);
  for (const std::uint64_t factor : {0xbf58476d1ce4e5b9U, 0x94d049bb133111ebU})
    bits = (bits ^ (bits >> 30)) * factor;
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace hearth
