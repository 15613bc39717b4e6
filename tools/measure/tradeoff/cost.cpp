#include "measure/tradeoff/cost.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "math/check.h"

namespace hearth {

TurnTimes timedInTurn(const std::function<double()>& base, const std::function<double()>& trial,
                      int repeats) {
  TurnTimes times{{base()}, {}};
  const double enough = repeats * times.bases.front();
  double all = 0;
  for (int i = 0; i < repeats && (i == 0 || all < enough); ++i) {
    times.trials.push_back(trial());
    all += times.trials.back();
    times.bases.push_back(base());
  }
  return times;
}

std::vector<double> ratiosOf(const TurnTimes& times) {
  CHECK(times.bases.size() == times.trials.size() + 1, times.bases.size(), times.trials.size());
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.trials.size(); ++i)
    for (const double base : {times.bases[i], times.bases[i + 1]})
      ratios.push_back(times.trials[i] / base);
  return ratios;
}

double costOf(std::vector<double> ratios) {
  CHECK(!ratios.empty());
  std::ranges::sort(ratios);
  const std::size_t last = ratios.size() - 1;
  return std::sqrt(ratios[last / 2] * ratios[ratios.size() / 2]);
}

}  // namespace hearth
