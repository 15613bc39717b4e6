#pragma once

#include <span>

#include "settings/quality.h"

/// What `hearth tradeoff` measured on the levels that come with Hearth, for those who give a time
/// and not settings: of all that was tried, what nothing else was both faster and nearer to truth
/// than. Other levels differ in what a setting costs and misses, but hardly in which are better.
namespace hearth {

struct MeasuredFrame {
  DrawSettings draw;
  double cost;   ///< time of a frame, as a fraction of one that is drawn exactly
  double over2;  ///< fraction of pixels that are off by more than 2 levels
};

struct MeasuredBake {
  BakeQuality bake;
  double cost;  ///< time of a bake, as a fraction of one with the level's own settings
  double rms;   ///< error of light, in levels of 255
};

/// Both from the nearest to truth to the fastest.
std::span<const MeasuredFrame> measuredFrames();
std::span<const MeasuredBake> measuredBakes();

/// Those that cost no more, the nearest to truth of them; else the fastest.
const MeasuredFrame& frameWithin(double cost);
const MeasuredBake& bakeWithin(double cost);

}  // namespace hearth
