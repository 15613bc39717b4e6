#pragma once

namespace hearth {

/// The least whole number that is not less than x, of 0 <= x < 2^31. Processors of today round up
/// in one instruction, but a program that runs on all x86-64 must not use it: std::ceil is a
/// function there, and takes a quarter of the search for visible spans.
inline int roundedUp(double x) {
  const int whole = static_cast<int>(x);
  return whole < x ? whole + 1 : whole;
}

}  // namespace hearth
