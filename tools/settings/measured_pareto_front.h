#pragma once

#include <span>

#include "settings/quality.h"

/// The Pareto front that `hearth tradeoff` measured on the levels that come with Hearth: of all
/// settings that were tried, those that no other beats both in time and in RMS error. They serve
/// users who give a time instead of settings. On other levels costs and errors differ, but hardly
/// the order of the settings.
namespace hearth {

struct MeasuredFrame {
  DrawSettings draw;
  double cost;  ///< time of a frame, as a fraction of one that is drawn exactly
  double rms;   ///< error of pictures, in levels of 255
  /// Fraction of pixels that are off by more than 2 levels. Squares of 3 x 3 pixels have fewer than
  /// those of 2 x 2, as they are exact in their centres, but these are farther off.
  double over2;
};

struct MeasuredBake {
  BakeQuality bake;
  double cost;  ///< time of a bake, as a fraction of one with the level's own settings
  double rms;   ///< error of light, in levels of 255
};

/// Both from the nearest to truth to the fastest.
std::span<const MeasuredFrame> measuredFrames();
std::span<const MeasuredBake> measuredBakes();

/// The one nearest to truth that costs no more; if none does, the fastest.
const MeasuredFrame& frameWithin(double cost);
const MeasuredBake& bakeWithin(double cost);

}  // namespace hearth
