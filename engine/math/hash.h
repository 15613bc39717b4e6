#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "math/vec.h"

namespace hearth {

/// FNV-1a of 64 bits (Fowler, Noll, Vo) over numbers of 8 bytes, the low byte first: the same on
/// every machine.
class Hash {
 public:
  std::uint64_t value() const { return value_; }

  void addWhole(std::uint64_t number) {
    constexpr std::uint64_t kPrime = 0x100000001b3;
    for (int shift = 0; shift < 64; shift += 8)
      value_ = (value_ ^ ((number >> shift) & 0xff)) * kPrime;
  }

  void addReal(double number) {
    addWhole(std::bit_cast<std::uint64_t>(number + 0.0));  // -0 and 0 are one place
  }

  void addText(std::string_view text) {
    addWhole(text.size());
    for (const char c : text) addWhole(static_cast<unsigned char>(c));
  }

  void addPoint(Vec2 p) {
    addReal(p.x);
    addReal(p.y);
  }

  void addPoint(Vec3 p) {
    addPoint(p.xy());
    addReal(p.z);
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace hearth
