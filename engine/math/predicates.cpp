#include "math/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hearth {

namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon() / 2;

/// A sum kept as doubles that do not overlap, smallest first.
class ExactSum {
 public:
  void add(double value) {
    for (std::size_t i = 0; i < count_; ++i) {
      const double sum = terms_[i] + value;
      const double virtualValue = sum - terms_[i];
      const double error = (terms_[i] - (sum - virtualValue)) + (value - virtualValue);
      terms_[i] = error;
      value = sum;
    }
    terms_[count_++] = value;
  }

  void addProduct(double a, double b) {
    const double product = a * b;
    const auto [aHigh, aLow] = split(a);
    const auto [bHigh, bLow] = split(b);
    add(aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow));
    add(product);
  }

  int sign() const {
    for (std::size_t i = count_; i-- > 0;)
      if (terms_[i] != 0) return terms_[i] > 0 ? 1 : -1;
    return 0;
  }

 private:
  struct Halves {
    double high;
    double low;
  };

  /// Dekker's split into two halves of 26 bits.
  static Halves split(double a) {
    const double c = 134217729.0 * a;
    const double high = c - (c - a);
    return {high, a - high};
  }

  std::array<double, 12> terms_{};
  std::size_t count_ = 0;
};

int exactOrientation(Vec2 a, Vec2 b, Vec2 c) {
  ExactSum sum;
  sum.addProduct(a.x, b.y);
  sum.addProduct(-a.x, c.y);
  sum.addProduct(-c.x, b.y);
  sum.addProduct(-a.y, b.x);
  sum.addProduct(a.y, c.x);
  sum.addProduct(c.y, b.x);
  return sum.sign();
}

}  // namespace

int orientation(Vec2 a, Vec2 b, Vec2 c) {
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (b.y - a.y) * (c.x - a.x);
  const double area = left - right;
  // Shewchuk's bound for this form of the determinant.
  const double bound = (3 + 16 * kUlp) * kUlp * (std::abs(left) + std::abs(right));
  if (area > bound) return 1;
  if (area < -bound) return -1;
  return exactOrientation(a, b, c);
}

bool meetsFirst(Vec2 eye, Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1) {
  // Of segments that do not cross, one lies on one side of the other's line: as seen from the eye,
  // b beyond a's line, or b before it, or else a before b's line.
  const int eyeOfA = orientation(a0, a1, eye);
  const int b0OfA = orientation(a0, a1, b0) * eyeOfA;
  const int b1OfA = orientation(a0, a1, b1) * eyeOfA;
  if (b0OfA <= 0 && b1OfA <= 0 && b0OfA + b1OfA < 0) return true;
  if (b0OfA >= 0 && b1OfA >= 0 && b0OfA + b1OfA > 0) return false;
  const int eyeOfB = orientation(b0, b1, eye);
  const int a0OfB = orientation(b0, b1, a0) * eyeOfB;
  const int a1OfB = orientation(b0, b1, a1) * eyeOfB;
  return a0OfB >= 0 && a1OfB >= 0 && a0OfB + a1OfB > 0;
}

}  // namespace hearth
