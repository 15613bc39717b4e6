#include "settings/measured_pareto_front.h"

#include <algorithm>
#include <array>

namespace hearth {

namespace {

// Means of `hearth tradeoff` on levels/tutorial.json and levels/keep.json, of costs as factors.

constexpr std::array kMeasuredFrames = {
    MeasuredFrame{{}, 1, 2.5, 0.073},
    MeasuredFrame{{.pixelSize = 2}, 0.64, 17.8, 0.62},
    MeasuredFrame{{.pixelSize = 3}, 0.46, 18.5, 0.60},
    MeasuredFrame{{.pixelSize = 4}, 0.33, 20.9, 0.70},
};

constexpr std::array kMeasuredBakes = {
    MeasuredBake{{0.25, true, 64, 0.25}, 24, 2.5}, MeasuredBake{{0.25, false, 64, 0.25}, 12, 2.7},
    MeasuredBake{{0.5, false, 16, 1}, 2.1, 4.0},   MeasuredBake{{1, false, 16, 1}, 0.75, 5.6},
    MeasuredBake{{1, false, 0, 2}, 0.30, 6.2},     MeasuredBake{{2, false, 0, 4}, 0.16, 8.5},
    MeasuredBake{{4, false, 0, 8}, 0.11, 12.5},
};

template <typename Measured>
const Measured& within(std::span<const Measured> front, double cost) {
  const auto fits = [cost](const Measured& of) { return of.cost <= cost; };
  const auto found = std::ranges::find_if(front, fits);
  return found == front.end() ? front.back() : *found;
}

}  // namespace

std::span<const MeasuredFrame> measuredFrames() { return kMeasuredFrames; }
std::span<const MeasuredBake> measuredBakes() { return kMeasuredBakes; }

const MeasuredFrame& frameWithin(double cost) { return within(measuredFrames(), cost); }
const MeasuredBake& bakeWithin(double cost) { return within(measuredBakes(), cost); }

}  // namespace hearth
