#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "measure/tradeoff/truth_pictures.h"

namespace hearth {

/// Of light alone, in levels, of the channel that is farthest off. What is drawn has whole levels:
/// their rounding alone is an RMS of 0.29.
struct LightError {
  double max = 0;
  double rms = 0;
  double p99 = 0;  ///< which 99 of 100 pixels do not exceed
};

/// Of lit pictures.
struct PictureError {
  double rms = 0;                 ///< levels, of all channels
  double over2 = 0;               ///< fraction of pixels that are off by more than 2 levels
  double over8 = 0;               ///< ... by more than 8
  std::int64_t largestPatch = 0;  ///< pixels of the largest patch of those
  double psnr = 0;  ///< dB; for information: it rates a slight difference everywhere like a hole
  double ssim = 0;  ///< structural similarity of brightness, mean over windows of 8 x 8 pixels
};

struct Errors {
  LightError light;
  PictureError picture;
};

/// Errors of all pictures of some settings, pooled.
class ErrorSums {
 public:
  /// What was drawn with light and texture, and with light alone.
  void add(const TruthPicture& truth, const Image& lit, const Image& light);
  Errors errors() const;

 private:
  std::vector<float> lightErrors_;
  PictureError counts_;  ///< not yet fractions
  double squares_ = 0;
  double ssimSum_ = 0;
  std::int64_t windows_ = 0;
  std::int64_t pixels_ = 0;
};

}  // namespace hearth
