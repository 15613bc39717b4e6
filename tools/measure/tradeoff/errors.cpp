#include "measure/tradeoff/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/compare.h"

namespace hearth {

namespace {

double square(double x) { return x * x; }

double brightness(Rgb color) { return (color.r + color.g + color.b) / 3.0; }

/// Sums over a window of two pictures.
struct WindowSums {
  double a = 0;
  double b = 0;
  double aa = 0;
  double bb = 0;
  double ab = 0;

  void add(double x, double y) {
    a += x;
    b += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
};

/// Z. Wang and others, "Image Quality Assessment: From Error Visibility to Structural Similarity",
/// 2004, with the constants given there.
double similarity(const WindowSums& sums, double count) {
  constexpr double kMeans = 0.01 * 255 * 0.01 * 255;
  constexpr double kSpreads = 0.03 * 255 * 0.03 * 255;
  const double a = sums.a / count;
  const double b = sums.b / count;
  const double spreadA = sums.aa / count - a * a;
  const double spreadB = sums.bb / count - b * b;
  const double together = sums.ab / count - a * b;
  return (2 * a * b + kMeans) * (2 * together + kSpreads) /
         ((a * a + b * b + kMeans) * (spreadA + spreadB + kSpreads));
}

constexpr int kWindow = 8;
constexpr int kWindowStep = 4;

double windowSimilarity(const Image& a, const Image& b, int left, int top) {
  WindowSums sums;
  for (int j = top; j < top + kWindow; ++j)
    for (int i = left; i < left + kWindow; ++i)
      sums.add(brightness(a.at(i, j)), brightness(b.at(i, j)));
  return similarity(sums, kWindow * kWindow);
}

double squaresApart(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgb p = a.pixels()[i];
    const Rgb q = b.pixels()[i];
    sum += (square(p.r - q.r) + square(p.g - q.g) + square(p.b - q.b)) / 3;
  }
  return sum;
}

LightError errorOf(std::vector<float> errors) {
  if (errors.empty()) return {};
  std::ranges::sort(errors);
  double squares = 0;
  for (const float error : errors) squares += square(error);
  const auto count = static_cast<double>(errors.size());
  const auto at99 = static_cast<std::size_t>(std::ceil(0.99 * count)) - 1;
  return {errors.back(), std::sqrt(squares / count), errors[at99]};
}

}  // namespace

void ErrorSums::add(const TruthPicture& truth, const Image& lit, const Image& light) {
  for (std::size_t i = 0; i < truth.light.size(); ++i) {
    const Vec3 exact = truth.light[i];
    const Rgb drawn = light.pixels()[i];
    lightErrors_.push_back(static_cast<float>(std::max(
        {std::abs(drawn.r - exact.x), std::abs(drawn.g - exact.y), std::abs(drawn.b - exact.z)})));
  }
  const PictureDifference difference = compare(truth.picture, lit, 8);
  counts_.over2 += static_cast<double>(difference.over2);
  counts_.over8 += static_cast<double>(difference.over8);
  counts_.largestPatch = std::max(counts_.largestPatch, difference.largestPatch);
  squares_ += squaresApart(truth.picture, lit);
  for (int j = 0; j + kWindow <= lit.height(); j += kWindowStep)
    for (int i = 0; i + kWindow <= lit.width(); i += kWindowStep, ++windows_)
      ssimSum_ += windowSimilarity(truth.picture, lit, i, j);
  pixels_ += static_cast<std::int64_t>(lit.pixels().size());
}

Errors ErrorSums::errors() const {
  Errors errors{errorOf(lightErrors_), counts_};
  const auto pixels = static_cast<double>(std::max<std::int64_t>(1, pixels_));
  errors.picture.over2 /= pixels;
  errors.picture.over8 /= pixels;
  errors.picture.rms = std::sqrt(squares_ / pixels);
  errors.picture.psnr = squares_ == 0 ? std::numeric_limits<double>::infinity()
                                      : 10 * std::log10(255.0 * 255.0 * pixels / squares_);
  errors.picture.ssim = ssimSum_ / static_cast<double>(std::max<std::int64_t>(1, windows_));
  return errors;
}

}  // namespace hearth
