#include "settings/measured_pareto_front.h"

#include <algorithm>
#include <array>

namespace hearth {

namespace {

// Means of `hearth tradeoff` on levels/tutorial.json and levels/keep.json, of costs as factors.

constexpr std::array kMeasuredFrames = {
    MeasuredFrame{{}, 1, 2.3, 0.066},
    MeasuredFrame{{.pixelSize = 2}, 0.47, 17, 0.61},
    MeasuredFrame{{.pixelSize = 3}, 0.33, 18, 0.60},
    MeasuredFrame{{.pixelSize = 4}, 0.21, 20, 0.70},
};

constexpr std::array kMeasuredBakes = {
    MeasuredBake{{0.25, true, 64}, 28, 2.3},  MeasuredBake{{0.25, false, 64}, 12, 2.4},
    MeasuredBake{{0.5, false, 16}, 2.1, 3.6}, MeasuredBake{{1, false, 16}, 0.77, 5.1},
    MeasuredBake{{1, false, 0}, 0.29, 5.7},   MeasuredBake{{2, false, 0}, 0.19, 7.8},
    MeasuredBake{{4, false, 0}, 0.15, 11.7},
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
